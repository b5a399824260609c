#include "linear/conjugate_gradients.h"

#include <array>
#include <cmath>

namespace whittle {

namespace {

using Row = Eigen::RowVector3d;  // a number for each right-hand side
using Columns = std::array<bool, 3>;
constexpr Columns kAll = {true, true, true};

void multiply(const SparseMatrix& A, const Points& X, Points& AX) {
  for (Index column = 0; column < A.cols(); ++column) {
    Row sum = Row::Zero();
    for (SparseMatrix::InnerIterator entry(A, column); entry; ++entry) sum += entry.value() * X.row(entry.row());
    AX.row(column) = sum;  // by symmetry
  }
}

Row dot(const Points& X, const Points& Y) {
  Row sum = Row::Zero();
  for (Index i = 0; i < X.rows(); ++i) sum += X.row(i).cwiseProduct(Y.row(i));
  return sum;
}

Row norm(const Points& X) { return dot(X, X).cwiseSqrt(); }

/// X ← X diag(scale) + Y diag(factor).
void combine(Points& X, const Row& scale, const Points& Y, const Row& factor) {
  for (Index i = 0; i < X.rows(); ++i) X.row(i) = X.row(i).cwiseProduct(scale) + Y.row(i).cwiseProduct(factor);
}

/// Quotients for the columns that are not finished, zero for the others.
Row quotient(const Row& dividend, const Row& divisor, const Columns& active) {
  Row result = Row::Zero();
  for (int c = 0; c < 3; ++c) {
    if (active[c] && divisor[c] != 0) result[c] = dividend[c] / divisor[c];
  }
  return result;
}

Status notDefinite() {
  return Status::failure(Code::numericalFailure,
                         "the linear system is not positive definite or holds numbers that are not finite");
}

}  // namespace

/// Each column is scaled to length 1, far from the limits of single precision. Columns with norm 0 stay 0.
void ConjugateGradients::precondition(SparseCholesky& preconditioner, const Row& norms) {
  step_.setZero();
  combine(step_, Row::Zero(), residual_, quotient(Row::Ones(), norms, kAll));
  preconditioner.solve(step_);
  combine(step_, norms, residual_, Row::Zero());
}

Status ConjugateGradients::solve(const SparseMatrix& A, SparseCholesky& preconditioner, const Points& B, Points& X,
                                 const Limits& limits, Report& report) {
  residual_.resize(B.rows(), 3), step_.resize(B.rows(), 3), direction_.resize(B.rows(), 3), image_.resize(B.rows(), 3);
  report = {};
  const Row scale = norm(B);
  if (!scale.allFinite()) return notDefinite();
  for (int c = 0; c < 3; ++c) {
    if (scale[c] == 0) X.col(c).setZero();
  }
  direction_.setZero(), image_.setZero();
  const auto measure = [&] {
    multiply(A, X, residual_);
    combine(residual_, -Row::Ones(), B, Row::Ones());
  };
  measure();

  Row length = Row::Zero(), descent = Row::Zero();  // α and R·Z of the iteration before
  for (;; ++report.iterations) {
    Row norms = norm(residual_);
    Columns active;
    for (int c = 0; c < 3; ++c) {
      active[c] = !(norms[c] <= limits.residual * scale[c]);  // numbers that are not finite are noticed below
      if (!active[c]) norms[c] = 0;
    }
    if (!(active[0] || active[1] || active[2]) || report.iterations == limits.iterations) break;
    precondition(preconditioner, norms);
    // β of Polak and Ribière, Z·(R − R_before) / (R·Z)_before: with a rounded preconditioner that of Fletcher and Reeves would
    // carry the rounding of every step into the next. R − R_before is −α Q.
    const Row beta = -quotient(length.cwiseProduct(dot(step_, image_)), descent, active);
    descent = dot(residual_, step_);
    combine(direction_, beta, step_, Row::Ones());
    multiply(A, direction_, image_);
    const Row curvature = dot(direction_, image_);
    for (int c = 0; c < 3; ++c) {
      if (active[c] && !(curvature[c] > 0 && std::isfinite(curvature[c]))) return notDefinite();
    }
    length = quotient(dot(direction_, residual_), curvature, active);
    combine(X, Row::Ones(), direction_, length);
    combine(residual_, Row::Ones(), image_, -length);
  }
  measure();
  report.residual = quotient(norm(residual_), scale, kAll).maxCoeff();
  return {};
}

}  // namespace whittle
