#include "optimization/low_rank_inverse.h"

#include "optimization/pseudo_inverse.h"

namespace whittle {

namespace {

/// Columns of K that say no more than others do.
constexpr double kSame = 1e-10;

}  // namespace

void LowRankInverse::take(const Eigen::MatrixXd& C, const std::vector<Index>& known, double rest) {
  columns_ = C;
  rest_ = rest;
  Eigen::MatrixXd inner = C.transpose() * C;
  for (std::size_t i = 0; i < known.size(); ++i) inner.row(static_cast<Index>(i)) += rest * C.row(known[i]);
  inner_ = pseudoInverse(inner, kSame);
}

Eigen::MatrixXd LowRankInverse::apply(const Eigen::MatrixXd& R) const {
  if (columns_.cols() == 0) return R / rest_;
  return (R - columns_ * (inner_ * (columns_.transpose() * R))) / rest_;
}

}  // namespace whittle
