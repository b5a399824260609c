#include "methods/local_global/cubic.h"

#include <algorithm>
#include <cmath>

#include "geometry/rotation_fit.h"
#include "methods/local_global/local_global.h"

namespace whittle {

namespace {

constexpr int kMaxAdmmSteps = 100;
constexpr double kPrimalTolerance = 1e-5;    // ε_abs of the printed method, on R n and z (of unit length)
constexpr double kDualTolerance = 1e-3;      // ε_abs for the dual residual, as a share of λ a
constexpr double kRelativeTolerance = 1e-3;  // ε_rel
constexpr double kInitialPenalty = 5;        // ρ₀ as a multiple of λ a
constexpr double kImbalance = 10;            // μ: residuals further apart than this change the penalty …
constexpr double kPenaltyFactor = 2;         // … by τ
const double kRoot3 = std::sqrt(3.0);

Vec3 shrink(const Vec3& x, double threshold) {
  return x.array().sign() * (x.array().abs() - threshold).max(0);
}

}  // namespace

void CubicLocalStep::prepare(const RestShape& rest, const Settings& settings) {
  const double cubeness = settings.numbers[0];  // λ, Eq. 1
  weights_ = cubeness * rest.areas;
  normals_ = &rest.normals;
  admm_.resize(weights_.size());
  begin();
}

void CubicLocalStep::begin() {
  for (std::size_t i = 0; i < admm_.size(); ++i) admm_[i] = {Vec3::Zero(), Vec3::Zero(), kInitialPenalty * weights_[i]};
}

double CubicLocalStep::fit(const std::vector<Mat3>& covariances, std::vector<Mat3>& rotations) {
  double energy = 0;
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    const Mat3& M = covariances[i];
    const Vec3 n = normals_->row(i).transpose();
    Mat3& R = rotations[i];
    if (weights_[i] > 0 && !n.isZero(0)) {
      solveVertex(M, n, weights_[i], admm_[i], R);
    } else {
      R = fitRotation(M, R);
    }
    energy += weights_[i] * (R * n).lpNorm<1>() - R.cwiseProduct(M.transpose()).sum();
  }
  return energy;
}

void CubicLocalStep::solveVertex(const Mat3& M, const Vec3& n, double weight, Admm& state, Mat3& R) const {
  auto& [z, u, rho] = state;
  for (int step = 0; step < kMaxAdmmSteps; ++step) {
    R = fitRotation(M + rho * n * (z - u).transpose(), R);
    const Vec3 p = R * n;
    const Vec3 before = z;
    z = shrink(p + u, weight / rho);
    u += p - z;

    const double primal = (z - p).norm();
    const double dual = rho * (z - before).norm();
    if (primal <= kRoot3 * kPrimalTolerance + kRelativeTolerance * std::max(p.norm(), z.norm()) &&
        dual <= kRoot3 * kDualTolerance * weight + kRelativeTolerance * rho * u.norm()) {
      return;
    }
    if (primal > kImbalance * dual / weight) {
      rho *= kPenaltyFactor;
      u /= kPenaltyFactor;
    } else if (dual / weight > kImbalance * primal) {
      rho /= kPenaltyFactor;
      u *= kPenaltyFactor;
    }
  }
}

MethodInfo cubicMethod() {
  return {"cubic", withSharedParameters({{"lambda", ParameterKind::number, Stale::weights, 0.2, 0, 100}}),
          [] { return std::unique_ptr<Method>(std::make_unique<LocalGlobal>(std::make_unique<CubicLocalStep>(), 1)); }};
}

}  // namespace whittle
