#pragma once

#include <functional>

#include "base/sparse_matrix.h"
#include "base/status.h"
#include "linear/columns.h"

namespace whittle {

/// Preconditioned conjugate gradients for any number of right-hand sides, each with coefficients of its own. Where the
/// preconditioner is a Cholesky factor, `SparseCholesky::solveRefined` is the way in.
class ConjugateGradients {
 public:
  struct Limits {
    double residual = 1e-12;  // ‖b − A x‖ / ‖b‖ of each column, > 0
    int iterations = 50;      // ≥ 0
  };
  struct Report {
    int iterations = 0;   // most that any column took
    double residual = 0;  // largest of the columns, computed from X
    bool reached = true;  // whether that is within the limit; rounding leaves about ε ‖A‖ ‖x‖ / ‖b‖, which may be more
  };

  /// Overwrites residuals (#unknowns×k, k ≤ `kBatch`, each column of length 1 or 0) with M⁻¹ times them, for a definite
  /// M that is near to A.
  using Preconditioner = std::function<void(Columns)>;

  /// Columns that go through the iteration together.
  static constexpr Index kBatch = 24;

  /// Solves A X = B. Allocates only if the number of unknowns or of columns is not that of the call before.
  /// @param A #unknowns×#unknowns, positive definite; only the lower triangle is read
  /// @param B #unknowns×k
  /// @param X #unknowns×k, in: where to start; out: the solution, or the best that the limits allow
  /// @returns `numericalFailure` if A turns out to be indefinite or numbers are not finite; X is then where that was
  ///   noticed
  Status solve(const SparseMatrix& A, const Preconditioner& precondition, ConstColumns B, Columns X,
               const Limits& limits, Report& report);

 private:
  using Block = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;  // #unknowns×columns
  using Row = Eigen::Matrix<double, 1, Eigen::Dynamic, Eigen::RowMajor, 1, kBatch>;      // a number for each column

  void take(ConstColumns B, Columns X, Index width);
  Status solveBatch(const SparseMatrix& A, const Preconditioner& precondition, const Limits& limits, Report& report);
  Status descend(const SparseMatrix& A, const Preconditioner& precondition, const Limits& limits, int& iterations);
  double measure(const SparseMatrix& A);
  Row openNorms(double limit) const;
  void improve(const Preconditioner& precondition, const Row& norms);

  Block rhs_;        // B
  Block solution_;   // X
  Block residual_;   // R = B − A X
  Block step_;       // Z = M⁻¹ R
  Block direction_;  // P
  Block image_;      // Q = A P
  Row scale_;        // ‖b‖
};

}  // namespace whittle
