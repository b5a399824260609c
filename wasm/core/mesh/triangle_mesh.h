#pragma once

#include "base/types.h"

namespace whittle {

/// A triangle mesh: anything that `validate` lets through, manifold or not, in any number of parts.
struct TriangleMesh {
  Points positions;     // #V×3
  Triangles triangles;  // #F×3

  Index vertexCount() const { return static_cast<Index>(positions.rows()); }
  Index faceCount() const { return static_cast<Index>(triangles.rows()); }
};

}  // namespace whittle
