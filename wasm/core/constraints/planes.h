#pragma once

#include <vector>

#include "base/status.h"
#include "constraints/handles.h"
#include "linear/row_planes.h"

namespace whittle {

/// A plane normal·x = offset and the vertices that are held on it.
struct Plane {
  std::vector<Index> vertices;  // may hold an index twice
  Vec3 normal;                  // unit
  double offset;                // in the frame of the positions that it holds

  friend bool operator==(const Plane& a, const Plane& b) {
    return a.vertices == b.vertices && a.normal == b.normal && a.offset == b.offset;
  }
};

/// A vertex may be on several: on two it is held on a line, on three in a point.
using Planes = std::vector<Plane>;

/// Fails with `badPlanes` where a plane has no direction or place, or (element: the vertex) where a vertex does not
/// exist or is on planes that have no point in common. Sizes are taken to be about 1.
Status validatePlanes(const Planes& planes, Index vertexCount);

/// Fails with `badPlanes` (element: the vertex) where a vertex is on a plane and a handle holds it beside that. One that
/// is held on the plane stays there.
Status validateHandlesOnPlanes(const Handles& handles, const Planes& planes);

/// The planes vertex by vertex.
std::vector<RowPlane> rowPlanes(const Planes& planes);

}  // namespace whittle
