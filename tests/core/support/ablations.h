#pragma once

#include <string>
#include <vector>

#include "constraints/handles.h"
#include "mesh/triangle_mesh.h"

namespace whittle::testing {

/// A gesture of the printed method, on surfaces in the unit frame, that can be made without a term: no parameter of the
/// product switches one off.
struct Ablation {
  std::string name;
  TriangleMesh mesh;
  Handles handles;

  /// Runs the core's alternation. Where the environment has WHITTLE_ABLATIONS, a folder, the shape before and after is
  /// kept there as OBJ, for pictures.
  /// @param without “whole”, “similarity”, “sphericity”, “normal”, or “size” and “size ×1000”, which have more of it
  Points run(const std::string& without) const;
};

/// A column that two points opposite to each other half way up pull wider.
Ablation widenedColumn();
/// A ball between two rods, pulled longer by its ends.
Ablation lengthenedPawn();
/// A bracket of two arms, one of which is pulled longer by its end.
Ablation pulledBracket();
/// A bar that is pulled longer by the points in the middle of its ends.
Ablation pulledBar();

/// Vertices of the side of a column, ring by ring.
std::vector<std::vector<Index>> ringsOf(const Points& column);
/// Vertices of the ball of a pawn.
std::vector<Index> ballVertices(const Points& pawn);

}  // namespace whittle::testing
