#include "methods/local_global/cubic_admm.h"

#include <algorithm>
#include <cmath>

#include "geometry/rotation_fit.h"

namespace whittle {

namespace {

constexpr double kInitialPenalty = 5;  // ρ₀ as a multiple of λ a
constexpr double kImbalance = 10;      // μ: residuals further apart than this change the penalty …
constexpr double kPenaltyFactor = 2;   // … by τ
const double kRoot3 = std::sqrt(3.0);

Vec3 shrink(const Vec3& x, double threshold) { return x.array().sign() * (x.array().abs() - threshold).max(0); }

}  // namespace

void CubicAdmm::begin(const Scalars& weights) {
  states_.resize(weights.size());
  for (std::size_t i = 0; i < states_.size(); ++i) states_[i] = {Vec3::Zero(), Vec3::Zero(), kInitialPenalty * weights[i]};
}

void CubicAdmm::solve(Index vertex, const Mat3& M, const Vec3& n, double weight, Mat3& R) {
  auto& [z, u, rho] = states_[vertex];
  for (int step = 0; step < tolerances_.maxSteps; ++step) {
    R = fitRotation(M + rho * n * (z - u).transpose(), R);
    const Vec3 p = R * n;
    const Vec3 before = z;
    z = shrink(p + u, weight / rho);
    u += p - z;

    const double primal = (z - p).norm();
    const double dual = rho * (z - before).norm();
    if (primal <= kRoot3 * tolerances_.primal + tolerances_.relative * std::max(p.norm(), z.norm()) &&
        dual <= kRoot3 * tolerances_.dual * weight + tolerances_.relative * rho * u.norm()) {
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

}  // namespace whittle
