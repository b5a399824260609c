#pragma once

#include "methods/local_global/edges/edge_set.h"
#include "methods/parameters.h"

namespace whittle {

/// What keeps the details of the input (2021, §4.1).
enum class Rigidity {
  arap,   // a rotation per vertex over spokes and rims
  farap,  // a rotation per face: bends freely, every triangle keeps its shape
  acap,   // a rotation and a scale per vertex: as conformal as possible
};

inline EdgeSetKind edgeSetOf(Rigidity rigidity) {
  return rigidity == Rigidity::farap ? EdgeSetKind::faces : EdgeSetKind::spokesAndRims;
}

/// The parameter that chooses among them; another one is another system altogether.
inline ParameterInfo rigidityParameter() { return choiceParameter("regularizer", Stale::all, {"arap", "farap", "acap"}); }

}  // namespace whittle
