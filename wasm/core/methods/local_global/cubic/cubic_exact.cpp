// Its twin in single precision, four vertices at a time: cubic_lanes.cpp.
#include "methods/local_global/cubic/cubic_exact.h"

#include <array>
#include <cmath>

#include "geometry/rotation_fit.h"
#include "geometry/rotation_newton.h"
#include "methods/local_global/cubic/cubic_search.h"
#include "methods/local_global/cubic/search_lanes.h"

namespace whittle {

namespace {

constexpr int kMaxNewtonSteps = 20;
constexpr double kConverged = 1e-12;  // |w|², about the error that the step leaves; the certificate looks at it again
constexpr double kRounding = 1e-9;
/// Weights up to this share of M, those of a λ of about 3.4, seldom leave a gap: then all that there is is searched.
constexpr double kLight = 0.4;

/// Which coordinates of s = R n are held at zero, where |s_j| has its kink and u_j is free.
using Kinks = std::array<bool, 3>;

/// The active set of u = clamp(u + s / kKinkShare), which says u ∈ ∂|s|₁ as an equation. Off the kinks u becomes the
/// sign.
Kinks activeKinks(const Vec3& s, const Vec3& weights, Vec3& u) {
  const Vec3 shifted = s + kKinkShare * u;
  Index largest;
  s.cwiseAbs().maxCoeff(&largest);  // s is of unit length: not all of it can be zero
  Kinks kinks;
  for (Index j = 0; j < 3; ++j) {
    kinks[j] = std::abs(shifted[j]) <= kKinkShare && j != largest && weights[j] > 0;
    if (!kinks[j]) u[j] = std::copysign(1.0, j == largest ? s[j] : shifted[j]);
  }
  return kinks;
}

/// Solves H w + C μ = g, Cᵀ w = −s on the kinks, with columns c_j = s × e_j (the way s_j goes when R turns). Fails
/// where the model has no maximum on the tangent space.
bool newtonStep(const RotationModel& model, const Vec3& s, const Kinks& kinks, const Vec3& weights, Vec3& w, Vec3& mu) {
  // A penalty on the constraints leaves the solution as it is and makes H definite wherever it is so on the tangent
  // space.
  Mat3 H = model.H;
  Vec3 g = model.g;
  std::array<Vec3, 2> c;
  std::array<Index, 2> at{};
  int count = 0;
  for (Index j = 0; j < 3; ++j) {
    if (!kinks[j]) continue;
    c[count] = s.cross(Vec3::Unit(j));
    at[count] = j;
    H += weights[j] * c[count] * c[count].transpose();
    g -= weights[j] * s[j] * c[count];
    ++count;
  }
  if (!isPositiveDefinite(H)) return false;
  const Mat3 inverse = H.inverse();
  w = inverse * g;
  mu.setZero();
  if (count == 1) {
    const Vec3 d = inverse * c[0];
    mu[at[0]] = (c[0].dot(w) + s[at[0]]) / c[0].dot(d);
    w -= mu[at[0]] * d;
  } else if (count == 2) {
    const Vec3 d0 = inverse * c[0], d1 = inverse * c[1];
    const double a = c[0].dot(d0), b = c[0].dot(d1), e = c[1].dot(d1);
    const double first = c[0].dot(w) + s[at[0]], second = c[1].dot(w) + s[at[1]];
    const double determinant = a * e - b * b;
    if (!(determinant > kRounding * a * e)) return false;
    mu[at[0]] = (e * first - b * second) / determinant;
    mu[at[1]] = (a * second - b * first) / determinant;
    w -= mu[at[0]] * d0 + mu[at[1]] * d1;
  }
  return true;
}

/// Whether u ∈ ∂|s|₁ but for rounding, and R maximises tr(R (M − κ n uᵀ)).
bool isCertified(const CubicVertex& vertex, const Vec3& u, const Mat3& R) {
  const Vec3 s = R * vertex.n;
  if (u.lpNorm<Eigen::Infinity>() > 1 + kRounding || s.lpNorm<1>() - u.dot(s) > kRounding) return false;
  const RotationModel model(R * vertex.pulled(u));
  return isPositiveDefinite(model.H) && model.g.norm() <= kRounding * model.H.trace();
}

bool climb(const CubicVertex& vertex, Vec3& u, Mat3& R) {
  for (int step = 0; step < kMaxNewtonSteps; ++step) {
    const Vec3 s = R * vertex.n;
    const Kinks kinks = activeKinks(s, vertex.weights, u);
    const RotationModel model(R * vertex.pulled(u));
    Vec3 w, mu;
    if (!newtonStep(model, s, kinks, vertex.weights, w, mu)) return false;
    const double turn = w.norm();
    const double share = turn > kLongestTurn ? kLongestTurn / turn : 1;
    R = cayley(share * w) * R;
    for (Index j = 0; j < 3; ++j) {
      if (kinks[j]) u[j] += share * mu[j] / vertex.weights[j];
    }
    // A wrong active set can be at rest too; the next step then changes it.
    if (turn * turn < kConverged && isCertified(vertex, u, R)) {
      R = orthonormalized(R);
      return true;
    }
  }
  return false;
}

/// From the dual's side: any u in the cube has a rotation where the model has its maximum.
bool climbFromDual(const CubicVertex& vertex, const Mat3& before, Vec3& u, Mat3& R) {
  u = (u.allFinite() ? u : Vec3(before * vertex.n)).cwiseMax(-1).cwiseMin(1);
  R = fitRotation(vertex.pulled(u), before);
  return climb(vertex, u, R);
}

/// κ·|R n|
Lanes regularizersAt(const VectorLanes& n, const VectorLanes& weights, const QuaternionLanes& rotations) {
  const VectorLanes s = toMatrix(rotations) * n;
  return weights.x * absolute(s.x) + weights.y * absolute(s.y) + weights.z * absolute(s.z);
}

}  // namespace

bool CubicExact::certify(const CubicVertex& vertex, Vec3& u, Mat3& R) {
  const Mat3 before = R;
  return climb(vertex, u, R) || climbFromDual(vertex, before, u, R);
}

bool CubicExact::solveCertified(const CubicVertex& vertex, Vec3& u, Mat3& R) {
  const Mat3 before = R;
  if (certify(vertex, u, R)) return true;
  R = searchCubic(PolyhedralVertex(vertex), before);
  u = (R * vertex.n).unaryExpr([](double s) { return std::abs(s) < kRounding ? 0 : std::copysign(1.0, s); });
  return false;
}

void CubicExact::begin(const FanLayout& layout) {
  subgradients_.assign(layout.batchCount(), {splat(0), splat(0), splat(0)});
  gaps_.assign(layout.batchCount(), LaneMask{});
  if (layout.most > 1) several_.begin(layout);
}

Lanes CubicExact::solve(std::size_t batch, const CubicLanes& vertices, QuaternionLanes& rotations) {
  if (vertices.fans.size() > 1) return several_.solve(batch, vertices, rotations);
  const auto& [n, weight] = vertices.fans[0];
  const VectorLanes axes{splat(static_cast<float>(axes_.x())), splat(static_cast<float>(axes_.y())),
                         splat(static_cast<float>(axes_.z()))};
  const VectorLanes weights{weight * axes.x, weight * axes.y, weight * axes.z};
  VectorLanes& u = subgradients_[batch];
  LaneMask& gaps = gaps_[batch];
  const VectorLanes uBefore = u;
  const QuaternionLanes before = rotations;
  auto [regularizers, certified, settled] = climbLanes(vertices.M, n, weights, gaps, u, rotations);
  if (all(certified)) return regularizers;
  regularizers = select(settled, regularizers, regularizersAt(n, weights, rotations));
  for (int lane = 0; lane < 4; ++lane) {
    if (certified[lane] || gaps[lane]) continue;
    const CubicVertex vertex{matrixAt(vertices.M, lane), vectorAt(n, lane).normalized(), vectorAt(weights, lane)};
    Mat3 R = rotationAt(before, lane);
    Vec3 subgradient = vectorAt(uBefore, lane);
    if (vertex.weights.isZero(0)) {
      R = fitRotation(vertex.M);
    } else if (vertex.weights.maxCoeff() <= kLight * vertex.M.norm()) {
      solveCertified(vertex, subgradient, R);
    } else if (!certify(vertex, subgradient, R)) {
      continue;
    }
    certified[lane] = -1;
    setRotation(rotations, lane, R);
    setVector(u, lane, subgradient);
    regularizers[lane] = static_cast<float>(vertex.regularizer(R * vertex.n));
  }
  gaps = ~certified;
  if (any(gaps)) search(vertices.M, n, weights, gaps, before, u, rotations, regularizers);
  return regularizers;
}

void CubicExact::search(const MatrixLanes& M, const VectorLanes& n, const VectorLanes& weights, LaneMask lanes,
                        const QuaternionLanes& before, VectorLanes& u, QuaternionLanes& rotations,
                        Lanes& regularizers) {
  takeBetter(M, before, select(lanes, regularizersAt(n, weights, before), splat(INFINITY)), rotations, regularizers);
  QuaternionLanes found = searchLanes(M, n, weights, rotations);
  const VectorLanes s = toMatrix(found) * n;
  const auto signOf = [](Lanes coordinate) {
    return keep(absolute(coordinate) > 1e-3f, withSign(splat(1), coordinate));
  };
  VectorLanes foundU{signOf(s.x), signOf(s.y), signOf(s.z)};
  const Climbed climbed = climbLanes(M, n, weights, ~LaneMask{}, foundU, found);
  const Lanes honest = select(climbed.settled, climbed.regularizers, regularizersAt(n, weights, found));
  const LaneMask better = takeBetter(M, found, select(lanes, honest, splat(INFINITY)), rotations, regularizers);
  u = select(better, foundU, u);
}

}  // namespace whittle
