#include "linear/conjugate_gradients.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace whittle {

namespace {

/// A X for a symmetric A, of which only the lower triangle is read.
template <typename Block>
void multiply(const SparseMatrix& A, const Block& X, Block& AX) {
  AX.setZero();
  for (Index column = 0; column < A.cols(); ++column) {
    for (SparseMatrix::InnerIterator entry(A, column); entry; ++entry) {
      if (entry.row() < column) continue;
      AX.row(entry.row()) += entry.value() * X.row(column);
      if (entry.row() > column) AX.row(column) += entry.value() * X.row(entry.row());
    }
  }
}

template <typename Row, typename Block>
Row dot(const Block& X, const Block& Y) {
  Row sum = Row::Zero(X.cols());
  for (Index i = 0; i < X.rows(); ++i) sum += X.row(i).cwiseProduct(Y.row(i));
  return sum;
}

/// X ← X diag(scale) + Y diag(factor).
template <typename Block, typename Row>
void combine(Block& X, const Row& scale, const Block& Y, const Row& factor) {
  for (Index i = 0; i < X.rows(); ++i) X.row(i) = X.row(i).cwiseProduct(scale) + Y.row(i).cwiseProduct(factor);
}

/// Quotients of columns, zero for those whose divisor is zero.
template <typename Row>
Row quotient(const Row& dividend, const Row& divisor) {
  return (divisor.array() == 0).select(Row::Zero(divisor.size()), dividend.cwiseQuotient(divisor));
}

/// The numbers of the columns that are open, zero for the others.
template <typename Row>
Row ofOpen(const Row& norms, const Row& numbers) {
  return (norms.array() == 0).select(Row::Zero(norms.size()), numbers);
}

Status notDefinite() {
  return Status::failure(Code::numericalFailure,
                         "the linear system is not positive definite or holds numbers that are not finite");
}

}  // namespace

Status ConjugateGradients::solve(const SparseMatrix& A, const Preconditioner& precondition, ConstColumns B, Columns X,
                                 const Limits& limits, Report& report) {
  report = {};
  if (B.count() == 0) return {};
  const Index batches = (B.count() + kBatch - 1) / kBatch;
  const Index width = (B.count() + batches - 1) / batches;
  Status status;
  for (Index first = 0; first < B.count() && status.ok(); first += width) {
    const Index count = std::min(width, B.count() - first);
    const Columns part = X.part(first, count);
    take(B.part(first, count), part, width);
    status = solveBatch(A, precondition, limits, report);
    for (Index i = 0; i < part.rows(); ++i) {
      for (Index c = 0; c < count; ++c) part(i, c) = solution_(i, c);
    }
  }
  report.reached = status.ok() && report.residual <= limits.residual;
  return status;
}

/// Columns that fill the batch up are zero.
void ConjugateGradients::take(ConstColumns B, Columns X, Index width) {
  for (Block* block : {&rhs_, &solution_, &residual_, &step_, &direction_, &image_}) block->resize(B.rows(), width);
  rhs_.setZero(), solution_.setZero();
  for (Index i = 0; i < B.rows(); ++i) {
    for (Index c = 0; c < B.count(); ++c) rhs_(i, c) = B(i, c), solution_(i, c) = X(i, c);
  }
}

Status ConjugateGradients::solveBatch(const SparseMatrix& A, const Preconditioner& precondition, const Limits& limits,
                                      Report& report) {
  scale_ = dot<Row>(rhs_, rhs_).cwiseSqrt();
  if (!scale_.allFinite()) return notDefinite();
  for (Index c = 0; c < scale_.size(); ++c) {
    if (scale_[c] == 0) solution_.col(c).setZero();
  }
  // The residual that is carried along in a descent drifts from the true one; where that shows, another descent starts
  // from there.
  constexpr double kWorthwhile = 0.5;
  int iterations = 0;
  double before = std::numeric_limits<double>::infinity(), left = measure(A);
  while (left > limits.residual && left < kWorthwhile * before && iterations < limits.iterations) {
    if (Status status = descend(A, precondition, limits, iterations); !status.ok()) return status;
    before = std::exchange(left, measure(A));
  }
  report.iterations = std::max(report.iterations, iterations);
  report.residual = std::max(report.residual, left);
  return std::isfinite(left) ? Status{} : notDefinite();
}

/// Computes the residuals from X. Returns the largest of their relative norms, infinity if one is not a number.
double ConjugateGradients::measure(const SparseMatrix& A) {
  multiply(A, solution_, residual_);
  residual_ = rhs_ - residual_;
  const Row relative = quotient<Row>(dot<Row>(residual_, residual_).cwiseSqrt(), scale_);
  return relative.allFinite() ? relative.maxCoeff() : std::numeric_limits<double>::infinity();
}

/// Norms of the residuals that are above the limit, zero for the others.
ConjugateGradients::Row ConjugateGradients::openNorms(double limit) const {
  Row norms = dot<Row>(residual_, residual_).cwiseSqrt();
  for (Index c = 0; c < norms.size(); ++c) {
    if (norms[c] <= limit * scale_[c]) norms[c] = 0;
  }
  return norms;
}

/// Z = M⁻¹ R. Each column is scaled to length 1, far from the limits of single precision.
void ConjugateGradients::improve(const Preconditioner& precondition, const Row& norms) {
  const Row ones = Row::Ones(norms.size()), zero = Row::Zero(norms.size());
  step_.setZero();
  combine(step_, zero, residual_, quotient<Row>(ones, norms));
  precondition(step_);
  combine(step_, norms, residual_, zero);
}

Status ConjugateGradients::descend(const SparseMatrix& A, const Preconditioner& precondition, const Limits& limits,
                                   int& iterations) {
  const Index columns = static_cast<Index>(rhs_.cols());
  const Row ones = Row::Ones(columns);
  direction_.setZero(), image_.setZero();
  Row length = Row::Zero(columns), descent = Row::Zero(columns);  // α and R·Z of the iteration before
  for (; iterations < limits.iterations; ++iterations) {
    const Row norms = openNorms(limits.residual);
    if (norms.isZero(0)) break;
    improve(precondition, norms);
    // β of Polak and Ribière, Z·(R − R_before) / (R·Z)_before: with a rounded preconditioner that of Fletcher and
    // Reeves would carry the rounding of every step into the next. R − R_before is −α Q.
    const Row beta = -ofOpen<Row>(norms, quotient<Row>(length.cwiseProduct(dot<Row>(step_, image_)), descent));
    descent = dot<Row>(residual_, step_);
    combine(direction_, beta, step_, ones);
    multiply(A, direction_, image_);
    const Row curvature = dot<Row>(direction_, image_);
    for (Index c = 0; c < columns; ++c) {
      if (norms[c] != 0 && !(curvature[c] > 0 && std::isfinite(curvature[c]))) return notDefinite();
    }
    length = ofOpen<Row>(norms, quotient<Row>(dot<Row>(direction_, residual_), curvature));
    combine(solution_, ones, direction_, length);
    combine(residual_, ones, image_, Row(-length));
  }
  return {};
}

}  // namespace whittle
