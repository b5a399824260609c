#pragma once

#include "base/sparse_matrix.h"
#include "base/status.h"
#include "linear/sparse_cholesky.h"

namespace whittle {

/// Preconditioned conjugate gradients for three right-hand sides at once. The preconditioner is a Cholesky factor, either
/// - of the same matrix: what separates the two is single precision, and two or three iterations give double precision; or
/// - of an older matrix on the same pattern: a system that changed little takes a few iterations instead of a factorization
///   (with weights between half and twice the old ones, about 12 for a residual of 1e-6).
class ConjugateGradients {
 public:
  struct Limits {
    double residual = 1e-12;  // ‖B − A X‖ / ‖B‖ of each column, > 0
    int iterations = 50;      // ≥ 0
  };
  struct Report {
    int iterations = 0;
    double residual = 0;  // largest of the three columns, computed from X; what the limit of iterations left, if it was that
  };

  /// Solves A X = B. Allocates only if the number of unknowns is not that of the last call.
  /// @param A #unknowns×#unknowns, positive definite; both triangles are read
  /// @param X #unknowns×3, in: where to start; out: the solution, or the best that the limits allow
  /// @returns `numericalFailure` if A turns out to be indefinite or numbers are not finite; X is then where that was noticed
  Status solve(const SparseMatrix& A, SparseCholesky& preconditioner, const Points& B, Points& X, const Limits& limits,
               Report& report);

 private:
  void precondition(SparseCholesky& preconditioner, const Eigen::RowVector3d& norms);

  Points residual_;   // R = B − A X
  Points step_;       // Z = M⁻¹ R
  Points direction_;  // P
  Points image_;      // Q = A P
};

}  // namespace whittle
