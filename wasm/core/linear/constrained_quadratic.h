#pragma once

#include <vector>

#include "linear/sparse_cholesky.h"

namespace whittle {

/// Minimises ½ tr(Xᵀ A X) − tr(Bᵀ X) over X (#n×3) with some rows of X held: the held rows are eliminated and the free
/// block is factored once for any number of right-hand sides and held values.
class ConstrainedQuadratic {
 public:
  /// Factors the free block of A (#n×#n, symmetric, positive definite on the free rows). `held` may hold an index twice.
  /// A is taken over and let go before the factorization, whose memory is the peak. Fails with `numericalFailure`.
  Status prepare(SparseMatrix A, const std::vector<Index>& held);

  /// Fills in the free rows of X; its held rows are read. Allocates nothing.
  void solve(const Points& B, Points& X);

 private:
  std::vector<Index> free_;    // rows of X that are solved for
  SparseMatrix coupling_;      // free×#n, A's free rows and held columns
  SparseCholesky cholesky_;
  Points rhs_;
};

}  // namespace whittle
