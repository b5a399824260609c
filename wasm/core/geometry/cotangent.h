#pragma once

#include <vector>

#include "base/sparse_matrix.h"
#include "base/types.h"

namespace whittle {

/// Half cotangents c_fe = ½ cot(angle opposite to edge e in face f), #F×3, corner k for the edge opposite to it.
/// Negative values are kept. Of a degenerate face the area is floored, so its stiffness is finite and still
/// semidefinite; a face that uses one vertex twice has none.
CornerScalars halfCotangents(const Points& positions, const Triangles& triangles);
/// Half cotangents without allocating, into `cotangents` (#F×3).
void halfCotangents(const Points& positions, const Triangles& triangles, CornerScalars& cotangents);

/// The lower triangle of the cotangent Laplacian L (#V×#V, symmetric positive semidefinite): L_ij = −Σ c_fe over the
/// faces of edge ij, rows of the whole sum to zero. The diagonal is always stored; of a vertex without a face it is
/// zero.
SparseMatrix cotangentLaplacian(const Triangles& triangles, const CornerScalars& halfCotangents, Index vertexCount);

/// The cotangent Laplacian of triangles whose vertices move: its pattern is found once and its values are filled in
/// anew without allocating.
class LaplacianPattern {
 public:
  /// @param held vertices whose rows and columns are those of the identity
  LaplacianPattern(const Triangles& triangles, Index vertexCount, const std::vector<Index>& held);

  /// Fills in values and returns `lower`.
  const SparseMatrix& fill(const CornerScalars& halfCotangents);
  /// The lower triangle of L with the values that were last filled in, positive definite where every part has a held
  /// vertex.
  const SparseMatrix& lower() const { return lower_; }

 private:
  static constexpr Index kNowhere = -1;

  const Triangles& triangles_;
  std::vector<bool> isHeld_;  // #V
  Eigen::Matrix<Index, Eigen::Dynamic, 3, Eigen::RowMajor>
      edgePlaces_;  // #F×3: where the edge opposite to a corner has its value
  SparseMatrix lower_;
};

}  // namespace whittle
