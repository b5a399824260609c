// Its twin in double precision, one vertex at a time: cubic_exact.cpp.
#include "methods/local_global/cubic/cubic_lanes.h"

#include "geometry/rotation_newton.h"
#include "methods/local_global/cubic/cubic_vertex.h"

namespace whittle {

namespace {

constexpr int kMaxNewtonSteps = 8;
constexpr float kLongest = static_cast<float>(kLongestTurn);
constexpr float kConverged =
    1e-5f;  // |w|²; the error that the step leaves falls with |w|³, on the kinks after `settled`
constexpr float kKink = static_cast<float>(kKinkShare);
constexpr float kOutside = 1e-4f;  // by how much a subgradient may leave [−1, 1]; the gap is of its square
constexpr float kRounding = 1e-6f;
constexpr float kStill = kTurnOfRounding * kTurnOfRounding;
constexpr float kDependent = 1e-6f;  // kinks whose constraints are that close to each other are not solved for

struct VectorMask {
  LaneMask x, y, z;
};

/// Which coordinates of s = R n are held at zero, where |s_j| has its kink and u_j is free; never the largest.
struct ActiveKinks {
  VectorMask at;
  LaneMask largestX, largestZ;

  ActiveKinks(const VectorLanes& s, const VectorLanes& weights, VectorLanes& u) {
    const Lanes x = absolute(s.x), y = absolute(s.y), z = absolute(s.z);
    largestX = (x >= y) & (x >= z);
    largestZ = ~largestX & (z > y);
    const LaneMask largestY = ~largestX & ~largestZ;
    at = {decide(s.x, weights.x, largestX, u.x), decide(s.y, weights.y, largestY, u.y),
          decide(s.z, weights.z, largestZ, u.z)};
  }

  /// Picks, of three values by axis, those of the two axes that can have a kink. (x and y, x and z, or y and z.)
  template <typename T>
  T first(const T& x, const T& y) const {
    return select(largestX, y, x);
  }
  template <typename T>
  T second(const T& y, const T& z) const {
    return select(largestZ, y, z);
  }

 private:
  /// The active set of u = clamp(u + s / kKink), which says u ∈ ∂|s|₁ as an equation. Off the kinks u becomes the sign.
  static LaneMask decide(Lanes s, Lanes weight, LaneMask largest, Lanes& u) {
    const Lanes shifted = s + kKink * u;
    const LaneMask kink = (absolute(shifted) <= kKink) & ~largest & (weight > 0);
    u = select(kink, u, withSign(splat(1), select(largest, s, shifted)));
    return kink;
  }
};

VectorLanes keepEach(const VectorMask& mask, const VectorLanes& v) {
  return {keep(mask.x, v.x), keep(mask.y, v.y), keep(mask.z, v.z)};
}

/// H + Σ_j p_j c_j c_jᵀ for c_j = s × e_j, the way s_j goes when R turns.
SymmetricLanes penalized(const SymmetricLanes& H, const VectorLanes& p, const VectorLanes& s) {
  const Lanes x = s.x * s.x, y = s.y * s.y, z = s.z * s.z;
  return {H.xx + p.y * z + p.z * y, H.xy - p.z * (s.x * s.y), H.xz - p.y * (s.x * s.z),
          H.yy + p.x * z + p.z * x, H.yz - p.x * (s.y * s.z), H.zz + p.x * y + p.y * x};
}

/// Shortens a turn to the length up to which the model holds; returns by which factor.
Lanes shorten(VectorLanes& w, Lanes squaredTurn) {
  if (!any(squaredTurn > kLongest * kLongest)) return splat(1);
  const Lanes share = minimum(kLongest / squareRoot(squaredTurn), splat(1));
  w = share * w;
  return share;
}

struct Step {
  VectorLanes w;
  Lanes first, second;  // change of u on the two axes that can have a kink
  LaneMask valid;
};

/// Solves H w + C μ = g, Cᵀ w = −s on the kinks, with columns c_j = s × e_j (the way s_j goes when R turns); κ_j δu_j =
/// μ_j.
Step newtonStep(const RotationModelLanes& model, const VectorLanes& s, const ActiveKinks& kinks,
                const VectorLanes& weights) {
  const Lanes zero = splat(0), one = splat(1);
  const VectorLanes penalty = keepEach(kinks.at, weights), pull{penalty.x * s.x, penalty.y * s.y, penalty.z * s.z};
  // A penalty on the constraints leaves the solution as it is and makes H definite wherever it is so on the tangent
  // space.
  const InverseLanes H(penalized(model.H, penalty, s));
  const VectorLanes w = H.inverse * (model.g - cross(s, pull));

  const VectorLanes ofX{zero, s.z, -s.y}, ofY{-s.z, zero, s.x}, ofZ{s.y, -s.x, zero};
  const LaneMask at0 = (LaneMask)kinks.first((Lanes)kinks.at.x, (Lanes)kinks.at.y);
  const LaneMask at1 = (LaneMask)kinks.second((Lanes)kinks.at.y, (Lanes)kinks.at.z);
  const VectorLanes c0 = keep(at0, kinks.first(ofX, ofY)), c1 = keep(at1, kinks.second(ofY, ofZ));
  const Lanes s0 = keep(at0, kinks.first(s.x, s.y)), s1 = keep(at1, kinks.second(s.y, s.z));
  const Lanes weight0 = kinks.first(weights.x, weights.y), weight1 = kinks.second(weights.y, weights.z);

  const VectorLanes d0 = H.inverse * c0, d1 = H.inverse * c1;
  const Lanes a = select(at0, dot(c0, d0), one), b = dot(c0, d1), e = select(at1, dot(c1, d1), one);
  const Lanes determinant = a * e - b * b;
  const Lanes rest0 = dot(c0, w) + s0, rest1 = dot(c1, w) + s1, inverse = one / determinant;
  const Lanes mu0 = inverse * (e * rest0 - b * rest1), mu1 = inverse * (a * rest1 - b * rest0);
  return {w - mu0 * d0 - mu1 * d1, keep(at0, mu0 / weight0), keep(at1, mu1 / weight1),
          H.definite & (determinant > kDependent * (a * e))};
}

/// Whether u_j ∈ ∂|s_j|: within the interval at a kink, else the sign.
LaneMask isSubgradient(Lanes u, Lanes s, Lanes weight, LaneMask kink) {
  const LaneMask inside = absolute(u) <= 1 + kOutside, sameSign = (u * s >= -kRounding) | (weight == 0);
  return (kink & inside) | (~kink & sameSign);
}

Lanes clamped(Lanes u) { return minimum(maximum(u, splat(-1)), splat(1)); }

}  // namespace

Climbed climbLanes(const MatrixLanes& M, const VectorLanes& n, const VectorLanes& weights, LaneMask open,
                   VectorLanes& u, QuaternionLanes& rotations) {
  LaneMask done{}, valid = ~done, certified = done;
  VectorMask kinksAtEnd{done, done, done};
  for (int step = 0; step < kMaxNewtonSteps && any(valid & ~done); ++step) {
    const MatrixLanes R = toMatrix(rotations);
    const VectorLanes s = R * n;
    VectorLanes next = u;
    const ActiveKinks kinks(s, weights, next);
    MatrixLanes A = R * M;
    const VectorLanes pull{weights.x * next.x, weights.y * next.y, weights.z * next.z};
    const Lanes turnedNormal[] = {s.x, s.y, s.z};
    for (int i = 0; i < 3; ++i) {
      A.m[i][0] -= turnedNormal[i] * pull.x, A.m[i][1] -= turnedNormal[i] * pull.y,
          A.m[i][2] -= turnedNormal[i] * pull.z;
    }
    const RotationModelLanes model(A);
    const Step newton = newtonStep(model, s, kinks, weights);
    valid &= newton.valid | done;
    const LaneMask active = valid & ~done;

    const Lanes squaredTurn = dot(newton.w, newton.w);
    VectorLanes w = keep(active & (squaredTurn > kStill), newton.w);
    const Lanes share = shorten(w, squaredTurn);
    const Lanes first = share * newton.first, second = share * newton.second;
    next.x += keep(kinks.at.x, first);
    next.y += keep(kinks.at.y, select(kinks.largestX, first, second));
    next.z += keep(kinks.at.z, second);
    rotations = turned(rotations, w);
    u = select(active, next, u);

    const VectorLanes after = s + cross(w, s);
    const LaneMask settled = active & (squaredTurn < kConverged) & isSubgradient(u.x, after.x, weights.x, kinks.at.x) &
                             isSubgradient(u.y, after.y, weights.y, kinks.at.y) &
                             isSubgradient(u.z, after.z, weights.z, kinks.at.z);
    // Without the penalty on the kinks, H tells a global maximum from a local one.
    const LaneMask proved = settled & isPositiveDefinite(model.H), finished = proved | (settled & open);
    certified |= proved;
    kinksAtEnd.x |= finished & kinks.at.x;
    kinksAtEnd.y |= finished & kinks.at.y;
    kinksAtEnd.z |= finished & kinks.at.z;
    done |= finished;
  }
  // The shortest turn that brings the coordinates at a kink to zero.
  const VectorLanes s = toMatrix(rotations) * n;
  const VectorLanes offKinks{keep(~kinksAtEnd.x, s.x), keep(~kinksAtEnd.y, s.y), keep(~kinksAtEnd.z, s.z)};
  rotations = nudged(rotations, cross(s, offKinks));
  u = {clamped(u.x), clamped(u.y), clamped(u.z)};
  return {weights.x * absolute(offKinks.x) + weights.y * absolute(offKinks.y) + weights.z * absolute(offKinks.z),
          certified & valid, done & valid};
}

LaneMask takeBetter(const MatrixLanes& M, const QuaternionLanes& other, Lanes otherRegularizers,
                    QuaternionLanes& rotations, Lanes& regularizers) {
  const Lanes offered = traceOfProduct(rotationChange(other), M) - otherRegularizers;
  const Lanes present = traceOfProduct(rotationChange(rotations), M) - regularizers;
  const LaneMask isLost = ~(present == present);  // not a number
  const LaneMask better = (offered - present > kRounding * largestEntries(M)) | (isLost & (offered == offered));
  rotations = select(better, other, rotations);
  regularizers = select(better, otherRegularizers, regularizers);
  return better;
}

}  // namespace whittle
