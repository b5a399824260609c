#pragma once

#include "base/sparse_matrix.h"
#include "base/types.h"

namespace whittle {

/// Half cotangents c_fe = ½ cot(angle opposite to edge e in face f), #F×3, corner k for the edge opposite to it. Negative
/// values are kept. Of a degenerate face the area is floored, so its stiffness is finite and still semidefinite; a face
/// that uses one vertex twice has none.
CornerScalars halfCotangents(const Points& positions, const Triangles& triangles);

/// Cotangent Laplacian L (#V×#V, symmetric positive semidefinite, both triangles stored): L_ij = −Σ c_fe over the faces
/// of edge ij, rows sum to zero. A vertex without a face has an empty row.
SparseMatrix cotangentLaplacian(const Triangles& triangles, const CornerScalars& halfCotangents, Index vertexCount);

}  // namespace whittle
