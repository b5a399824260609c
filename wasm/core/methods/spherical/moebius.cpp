#include "methods/spherical/moebius.h"

#include <Eigen/Cholesky>
#include <algorithm>

namespace whittle {

namespace {

constexpr int kMaxSteps = 50;
constexpr double kBalanced = 1e-10;
/// Newton's step is trusted this far; further out the sphere would be squeezed into a point.
constexpr double kLongestStep = 0.5;

Vec3 imbalance(const Scalars& weights, const Points& points) { return points.transpose() * weights / weights.sum(); }

/// The boost that balances the points to first order: 2 Σ w (I − p pᵀ) c = −Σ w p.
Vec3 newtonBoost(const Scalars& weights, const Points& points, const Vec3& offset) {
  Mat3 spread = Mat3::Identity();
  for (Index v = 0; v < points.rows(); ++v) {
    spread -= weights[v] / weights.sum() * points.row(v).transpose() * points.row(v);
  }
  const Vec3 c = -0.5 * spread.ldlt().solve(offset);
  return c * std::min(1.0, kLongestStep / c.norm());
}

void boost(const Vec3& c, Points& points) {
  for (Index v = 0; v < points.rows(); ++v) {
    points.row(v) = moebiusBoost(points.row(v).transpose(), c).normalized().transpose();
  }
}

}  // namespace

Vec3 moebiusBoost(const Vec3& p, const Vec3& c) {
  const Vec3 q = p + c;
  return (1 - c.squaredNorm()) / q.squaredNorm() * q + c;
}

void balanceOnSphere(const Scalars& weights, Points& points) {
  Vec3 offset = imbalance(weights, points);
  Points boosted;
  for (int step = 0; step < kMaxSteps && offset.norm() > kBalanced; ++step) {
    Vec3 c = newtonBoost(weights, points, offset);
    Vec3 left;
    do {
      boosted = points;
      boost(c, boosted);
      left = imbalance(weights, boosted);
      c *= 0.5;
    } while (left.norm() >= offset.norm() && c.norm() > kBalanced);
    if (!(left.norm() < offset.norm())) return;
    points.swap(boosted);
    offset = left;
  }
}

double meanSquareButBoost(const Scalars& weights, const Points& p, const Points& d) {
  // ∫ (I − p pᵀ) over the sphere is two thirds of its area, which makes the fit a mean.
  Vec3 b = Vec3::Zero();
  for (Index v = 0; v < p.rows(); ++v) b += weights[v] * (d.row(v) - d.row(v).dot(p.row(v)) * p.row(v)).transpose();
  b *= 1.5 / weights.sum();
  double left = 0, whole = 0;
  for (Index v = 0; v < p.rows(); ++v) {
    const Vec3 normal = p.row(v).transpose();
    left += weights[v] * (d.row(v).transpose() - (b - b.dot(normal) * normal)).squaredNorm();
    whole += weights[v] * d.row(v).squaredNorm();
  }
  return std::min(left, whole) / weights.sum();
}

}  // namespace whittle
