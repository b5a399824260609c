#include "methods/local_global/cubic/cubic_admm.h"

#include <algorithm>
#include <cmath>

#include "geometry/rotation_fit.h"

namespace whittle {

namespace {

constexpr double kImbalance = 10;     // μ: residuals further apart than this change the penalty …
constexpr double kPenaltyFactor = 2;  // … by τ
const double kRoot3 = std::sqrt(3.0);

/// The point z that minimises ½|z − x|² + t Σ l_j |b_j · z|: x less the nearest t Σ l_j u_j b_j with u in the box, by
/// coordinate descent. For the cube one sweep is soft thresholding.
Vec3 shrink(const Vec3& x, double t, const Polyhedron& polyhedron) {
  constexpr int kMaxSweeps = 100;
  constexpr double kStill = 1e-13;
  std::array<double, Polyhedron::kMostRows> u{};
  Vec3 z = x;
  double change = 1;
  for (int sweep = 0; sweep < kMaxSweeps && change > kStill; ++sweep) {
    change = 0;
    for (Index j = 0; j < polyhedron.rowCount; ++j) {
      const double step = t * polyhedron.lengths[j];
      const double next = std::clamp(u[j] + polyhedron.rows[j].dot(z) / step, -1.0, 1.0);
      z -= step * (next - u[j]) * polyhedron.rows[j];
      change = std::max(change, std::abs(next - u[j]));
      u[j] = next;
    }
  }
  return z;
}

}  // namespace

void CubicAdmm::begin(std::size_t batches) { states_.assign(4 * batches, {}); }

Lanes CubicAdmm::solve(std::size_t batch, const CubicLanes& vertices, QuaternionLanes& rotations) {
  Lanes regularizers;
  for (int lane = 0; lane < 4; ++lane) {
    const CubicVertex vertex = vertexAt(vertices, lane);
    Mat3 R = rotationAt(rotations, lane);
    const double weight = vertex.weights.maxCoeff();
    solve(vertex.M, vertex.n, weight, states_[4 * batch + lane], R);
    setRotation(rotations, lane, R);
    regularizers[lane] = static_cast<float>(weight * polyhedron_.support(R * vertex.n));
  }
  return regularizers;
}

void CubicAdmm::solve(const Mat3& M, const Vec3& n, double weight, State& state, Mat3& R) const {
  if (weight == 0) {
    R = fitRotation(M, R);
    return;
  }
  auto& [z, u, rho] = state;
  for (int step = 0; step < tolerances_.maxSteps; ++step) {
    R = fitRotation(M + rho * weight * n * (z - u).transpose(), R);
    const Vec3 p = R * n;
    const Vec3 before = z;
    z = shrink(p + u, 1 / rho, polyhedron_);
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
