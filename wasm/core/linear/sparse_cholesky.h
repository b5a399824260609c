#pragma once

#include <Eigen/SparseCholesky>

#include "base/sparse_matrix.h"
#include "base/status.h"

namespace whittle {

/// Cholesky factorization P A Pᵀ = L Lᵀ of a sparse symmetric positive definite matrix, in three stages so that a caller
/// repeats only what changed: `analyze` for a new pattern, `factorize` for new values, `solve` for a new right-hand side.
class SparseCholesky {
 public:
  /// Orders the unknowns (approximate minimum degree) and finds the pattern of L. Reads only the pattern, and as
  /// everywhere here only the lower triangle, of A.
  void analyze(const SparseMatrix& A);

  /// Computes L for a matrix of the analyzed pattern. Fails with `numericalFailure` if A is not positive definite.
  Status factorize(const SparseMatrix& A);

  /// Overwrites three right-hand sides (#unknowns×3) with the solutions, in one pass over L. Allocates nothing.
  void solve(Points& rhs);

 private:
  Eigen::SimplicialLLT<SparseMatrix, Eigen::Lower, Eigen::AMDOrdering<Index>> llt_;
  Points permuted_;  // right-hand sides in the factor's order
};

}  // namespace whittle
