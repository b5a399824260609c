#pragma once

#include <vector>

#include "base/status.h"

namespace whittle {

/// Vertices held at given places.
struct Handles {
  std::vector<Index> vertices;
  Points targets = Points(0, 3);  // #handles×3, in the same frame as the positions they hold
};

/// Fails with `badHandles` (element: the vertex) where a vertex does not exist, is held twice or its target is not
/// finite.
Status validateHandles(const Handles& handles, Index vertexCount);

/// Moves the held vertices to their targets.
void applyHandles(const Handles& handles, Points& positions);

}  // namespace whittle
