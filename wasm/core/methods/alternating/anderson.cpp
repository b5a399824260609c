#include "methods/alternating/anderson.h"

#include <Eigen/Cholesky>
#include <algorithm>

namespace whittle {

namespace {

/// The share of the largest product that is added to the diagonal, so that changes which are nearly combinations of the
/// others count for nothing.
constexpr double kRegularizer = 1e-10;

}  // namespace

void Anderson::begin(Index vertexCount) {
  seen_ = 0;
  for (Points* points : {&stepBefore_, &resultBefore_}) points->resize(vertexCount, 3);
  for (std::vector<Points>* ring : {&steps_, &results_}) {
    ring->resize(kDepth);
    for (Points& points : *ring) points.resize(vertexCount, 3);
  }
}

void Anderson::next(const Points& result, Points& x) {
  x = result - x;  // the step
  if (seen_ > 0) {
    const int slot = (seen_ - 1) % kDepth;
    steps_[slot] = x - stepBefore_;
    results_[slot] = result - resultBefore_;
  }
  stepBefore_ = x;
  resultBefore_ = result;
  const int count = std::min(seen_++, kDepth);
  x = result;
  if (count == 0) return;
  Eigen::Matrix<double, kDepth, kDepth> products = Eigen::Matrix<double, kDepth, kDepth>::Identity();
  Eigen::Matrix<double, kDepth, 1> right = Eigen::Matrix<double, kDepth, 1>::Zero();
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j <= i; ++j) products(i, j) = products(j, i) = steps_[i].cwiseProduct(steps_[j]).sum();
    right[i] = steps_[i].cwiseProduct(stepBefore_).sum();
  }
  const double largest = products.topLeftCorner(count, count).diagonal().maxCoeff();
  if (!(largest > 0)) return;
  products.diagonal().array() += kRegularizer * largest;
  const Eigen::Matrix<double, kDepth, 1> shares = products.ldlt().solve(right);
  for (int i = 0; i < count; ++i) x -= shares[i] * results_[i];
}

}  // namespace whittle
