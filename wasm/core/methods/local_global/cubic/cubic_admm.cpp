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

void CubicAdmm::begin(const FanLayout& layout) {
  layout_ = &layout;
  states_.assign(4 * layout.slotCount(), {});
  normals_.resize(static_cast<std::size_t>(layout.most));
}

Lanes CubicAdmm::solve(std::size_t batch, const CubicLanes& vertices, QuaternionLanes& rotations) {
  Lanes regularizers;
  const std::size_t count = vertices.fans.size();
  State* states = &states_[4 * static_cast<std::size_t>(layout_->start[batch])];
  for (int lane = 0; lane < 4; ++lane, states += count) {
    const FanNormals normals = normalsAt(vertices, lane, normals_);
    Mat3 R = rotationAt(rotations, lane);
    solve(matrixAt(vertices.M, lane), normals, {states, count}, R);
    setRotation(rotations, lane, R);
    regularizers[lane] = static_cast<float>(polyhedron_.regularizer(normals, R));
  }
  return regularizers;
}

void CubicAdmm::solve(const Mat3& M, FanNormals normals, std::span<State> states, Mat3& R) const {
  double weight = 0;
  for (const FanNormal& normal : normals) weight += normal.weight;
  if (weight == 0) {
    R = fitRotation(M, R);
    return;
  }
  for (int step = 0; step < tolerances_.maxSteps; ++step) {
    const double rho = states[0].rho;
    Mat3 target = M;
    for (std::size_t k = 0; k < normals.size(); ++k)
      target += rho * normals[k].weight * normals[k].n * (states[k].z - states[k].u).transpose();
    R = fitRotation(target, R);
    if (updateDuals(normals, states, R)) return;
  }
}

bool CubicAdmm::updateDuals(FanNormals normals, std::span<State> states, const Mat3& R) const {
  double& rho = states[0].rho;
  double primal = 0, dual = 0, turned = 0, split = 0, scaledDual = 0;  // squared lengths over all normals
  for (std::size_t k = 0; k < normals.size(); ++k) {
    if (normals[k].weight == 0) continue;
    auto& [z, u, unused] = states[k];
    const Vec3 p = R * normals[k].n, before = z;
    z = shrink(p + u, 1 / rho, polyhedron_);
    u += p - z;
    primal += (z - p).squaredNorm(), dual += (z - before).squaredNorm();
    turned += p.squaredNorm(), split += z.squaredNorm(), scaledDual += u.squaredNorm();
  }
  primal = std::sqrt(primal), dual = rho * std::sqrt(dual);  // the dual one as a share of κ
  const double size = std::sqrt(std::max(turned, split));
  if (primal <= kRoot3 * tolerances_.primal + tolerances_.relative * size &&
      dual <= kRoot3 * tolerances_.dual + tolerances_.relative * rho * std::sqrt(scaledDual)) {
    return true;
  }
  double factor = 1;
  if (primal > kImbalance * dual) factor = kPenaltyFactor;
  if (dual > kImbalance * primal) factor = 1 / kPenaltyFactor;
  rho *= factor;
  for (State& state : states) state.u /= factor;
  return false;
}

}  // namespace whittle
