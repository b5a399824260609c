#pragma once

#include "methods/local_global/edges/edge_set.h"
#include "methods/values/choice.h"

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

/// The kind of the parameter that chooses among them; another one is another system altogether.
inline ChoiceKind<Rigidity> rigidities() {
  return {{{"arap", Rigidity::arap}, {"farap", Rigidity::farap}, {"acap", Rigidity::acap}}};
}

}  // namespace whittle
