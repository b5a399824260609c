#include "methods/local_global/cubic_admm.h"

#include <algorithm>
#include <cmath>

#include "geometry/rotation_fit.h"

namespace whittle {

namespace {

constexpr double kImbalance = 10;      // μ: residuals further apart than this change the penalty …
constexpr double kPenaltyFactor = 2;   // … by τ
const double kRoot3 = std::sqrt(3.0);

Vec3 shrink(const Vec3& x, const Vec3& thresholds) { return x.array().sign() * (x.cwiseAbs() - thresholds).array().max(0); }

}  // namespace

void CubicAdmm::begin(std::size_t batches, const std::vector<VectorLanes>&) { states_.assign(4 * batches, {}); }

Lanes CubicAdmm::solve(std::size_t batch, const CubicLanes& vertices, QuaternionLanes& rotations) {
  Lanes regularizers;
  for (int lane = 0; lane < 4; ++lane) {
    const CubicVertex vertex = vertexAt(vertices, lane);
    Mat3 R = rotationAt(rotations, lane);
    solve(vertex, states_[4 * batch + lane], R);
    setRotation(rotations, lane, R);
    regularizers[lane] = static_cast<float>(vertex.regularizer(R * vertex.n));
  }
  return regularizers;
}

void CubicAdmm::solve(const CubicVertex& vertex, State& state, Mat3& R) const {
  const auto& [M, n, weights] = vertex;
  const double weight = weights.maxCoeff();
  if (weight == 0) {
    R = fitRotation(M, R);
    return;
  }
  auto& [z, u, rho] = state;
  for (int step = 0; step < tolerances_.maxSteps; ++step) {
    R = fitRotation(M + rho * weight * n * (z - u).transpose(), R);
    const Vec3 p = R * n;
    const Vec3 before = z;
    z = shrink(p + u, weights / (rho * weight));
    u += p - z;

    const double primal = (z - p).norm();
    const double dual = rho * (z - before).norm();  // as a share of κ
    if (primal <= kRoot3 * tolerances_.primal + tolerances_.relative * std::max(p.norm(), z.norm()) &&
        dual <= kRoot3 * tolerances_.dual + tolerances_.relative * rho * u.norm()) {
      return;
    }
    if (primal > kImbalance * dual) {
      rho *= kPenaltyFactor;
      u /= kPenaltyFactor;
    } else if (dual > kImbalance * primal) {
      rho /= kPenaltyFactor;
      u *= kPenaltyFactor;
    }
  }
}

}  // namespace whittle
