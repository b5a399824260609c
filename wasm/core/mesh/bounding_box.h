#pragma once

#include "mesh/triangle_mesh.h"

namespace whittle {

using Box = Eigen::AlignedBox3d;

/// The smallest box around the vertices that faces use.
Box boundingBox(const TriangleMesh& mesh);

}  // namespace whittle
