// The twin of the library is src/mesh/extent.ts; both share their constants.
#pragma once

#include <vector>

#include "mesh/triangle_mesh.h"

namespace whittle {

/// The vertices, rising, that say how large a mesh is: those of faces without far strays. An empty gap is far if it is
/// a hundred times as long as all that faces cover on the axis on which they cover most; of the pieces that far gaps
/// cut the mesh into, along one axis after the other, the one with the largest surface counts. All vertices of faces
/// must be finite.
std::vector<Index> significantVertices(const TriangleMesh& mesh);

}  // namespace whittle
