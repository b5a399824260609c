#pragma once

#include "mesh/triangle_mesh.h"

namespace whittle {

/// Why a mesh cannot be worked on as it is.
enum class RemeshCause {
  none,
  slivers,      // more than 2 % of the area is in faces of quality below 0.1
  unevenEdges,  // the longest edge is more than 10 times the median
  coarseness,   // the median edge is more than 0.06 of the longest side of the box
};

/// Whether a mesh has to be remeshed before it is reshaped: the first cause that it gives.
RemeshCause needsRemeshing(const TriangleMesh& mesh);

/// Length of edges to remesh to on what is flat, in the mesh's units: 0.04 of the longest side, or more where that would
/// make more than some 120 000 faces. Where the surface curves the remesher goes finer (`edgeSizes`).
/// @param mesh without slivers
/// @param featureAngle in degrees
double remeshedEdge(const TriangleMesh& mesh, double featureAngle = 35);

}  // namespace whittle
