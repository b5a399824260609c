#include "methods/local_global/cubic/polyhedral_lanes.h"

#include "geometry/rotation_newton.h"

namespace whittle {

namespace {

constexpr int kMaxSteps = 16;
constexpr float kLongest = static_cast<float>(kLongestTurn);
constexpr float kConverged = 1e-7f;  // |w|², which the constraints feel
constexpr float kAtKink = 5e-7f;     // |b · R n| that counts as zero
constexpr float kKink = static_cast<float>(kKinkShare);
constexpr float kOutside = 1e-4f;  // by how much a subgradient may leave [−1, 1]
constexpr float kRounding = 1e-6f;
/// ρ, for covariances of size 1: each step leaves about 1/ρ of a violated constraint.
constexpr float kPenalty = 50;  // on kinks that turn away, of the size of M

/// A polyhedron's rows in single precision.
struct Row {
  float x, y, z, length;

  Row(const Polyhedron& polyhedron, Index j)
      : x(static_cast<float>(polyhedron.rows[j].x())), y(static_cast<float>(polyhedron.rows[j].y())),
        z(static_cast<float>(polyhedron.rows[j].z())), length(static_cast<float>(polyhedron.lengths[j])) {}

  Lanes dot(const VectorLanes& s) const { return x * s.x + y * s.y + z * s.z; }
  /// s × b, the way b · s goes when s turns.
  VectorLanes crossed(const VectorLanes& s) const { return {s.y * z - s.z * y, s.z * x - s.x * z, s.x * y - s.y * x}; }
};

/// R M − s yᵀ
MatrixLanes pulled(const MatrixLanes& RM, const VectorLanes& s, const VectorLanes& y) {
  const Lanes rows[] = {s.x, s.y, s.z}, columns[] = {y.x, y.y, y.z};
  MatrixLanes A = RM;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) A.m[i][j] -= rows[i] * columns[j];
  }
  return A;
}

}  // namespace

PolyhedralClimb climbPolyhedral(const MatrixLanes& M, const VectorLanes& n, Lanes weights, const Polyhedron& polyhedron,
                                SubgradientLanes& u, QuaternionLanes& rotations) {
  const Index rowCount = polyhedron.rowCount;
  const Lanes stiffness = kPenalty * largestEntries(M);
  LaneMask done{}, valid = ~done;
  std::array<LaneMask, Polyhedron::kMostRows> kink{};
  for (int step = 0; step < kMaxSteps && any(valid & ~done); ++step) {
    const MatrixLanes R = toMatrix(rotations);
    const VectorLanes s = R * n;
    const LaneMask open = valid & ~done;
    VectorLanes y{splat(0), splat(0), splat(0)};
    for (Index j = 0; j < rowCount; ++j) {
      const Row row(polyhedron, j);
      const Lanes shifted = row.dot(s) + kKink * u[j];
      kink[j] = select(open, (absolute(shifted) <= kKink) & (weights > 0), kink[j]);
      u[j] = select(open & ~kink[j], withSign(splat(1), shifted), u[j]);
      const Lanes pull = row.length * weights * u[j];
      y = {y.x + pull * row.x, y.y + pull * row.y, y.z + pull * row.z};
    }
    const RotationModelLanes model(pulled(R * M, s, y));
    SymmetricLanes H = model.H;
    VectorLanes g = model.g;
    for (Index j = 0; j < rowCount; ++j) {
      const Row row(polyhedron, j);
      const Lanes penalty = keep(kink[j], stiffness);
      const VectorLanes c = row.crossed(s);
      H = plusOuter(H, penalty, c);
      g = g - (penalty * row.dot(s)) * c;
    }
    const InverseLanes inverse(H);
    valid &= inverse.definite | done;
    const VectorLanes newton = inverse.inverse * g;
    const Lanes squaredTurn = dot(newton, newton);
    const Lanes share = select(squaredTurn > kLongest * kLongest, kLongest / squareRoot(squaredTurn), splat(1));
    const VectorLanes w = keep(valid & ~done, share * newton);
    rotations = turned(rotations, keep(squaredTurn > kTurnOfRounding * kTurnOfRounding, w));

    const VectorLanes after = s + cross(w, s);
    LaneMask finished = valid & ~done & (squaredTurn < kConverged) & isPositiveDefinite(model.H);
    for (Index j = 0; j < rowCount; ++j) {
      const Row row(polyhedron, j);
      const Lanes left = row.dot(after);
      const Lanes multiplier = share * stiffness * left / (row.length * weights);
      u[j] = select(valid & ~done & kink[j], u[j] + multiplier, u[j]);
      const LaneMask atKink = (absolute(left) <= kAtKink) & (absolute(u[j]) <= 1 + kOutside);
      const LaneMask offKink = (u[j] * left >= -kRounding) | (weights == 0);
      finished &= (kink[j] & atKink) | (~kink[j] & offKink);
    }
    done |= finished;
  }
  Lanes regularizers = splat(0);
  const VectorLanes s = toMatrix(rotations) * n;
  for (Index j = 0; j < rowCount; ++j) {
    const Row row(polyhedron, j);
    regularizers += keep(~kink[j], row.length * weights * absolute(row.dot(s)));
    u[j] = minimum(maximum(u[j], splat(-1)), splat(1));
  }
  return {regularizers, done & valid};
}

}  // namespace whittle
