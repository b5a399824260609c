#include "methods/local_global/cubic/polyhedral_lanes.h"

#include "geometry/rotation_newton.h"

namespace whittle {

namespace {

constexpr int kMaxSteps = 16;
constexpr int kMaxOpenSteps = 8;  // where nobody needs a certificate, and what is not settled then seldom will be
constexpr float kLongest = static_cast<float>(kLongestTurn);
constexpr float kConverged = 1e-7f;  // |w|², which the constraints feel
constexpr float kAtKink = 5e-7f;     // |b · R n| that counts as zero
constexpr float kKink = static_cast<float>(kKinkShare);
constexpr float kOutside = 1e-4f;  // by how much a subgradient may leave [−1, 1]
constexpr float kRounding = 1e-6f;
/// ρ, for covariances of size 1: each step leaves about 1/ρ of a violated constraint.
constexpr float kPenalty = 50;  // on kinks that turn away, of the size of M

using Row = PolyhedronRows::Row;

/// A row of any polyhedron.
struct AnyRow {
  const Row& b;

  Lanes dot(const VectorLanes& s) const { return b.x * s.x + b.y * s.y + b.z * s.z; }
  /// y + pull b
  void pull(VectorLanes& y, Lanes pull) const { y = {y.x + pull * b.x, y.y + pull * b.y, y.z + pull * b.z}; }
  /// Adds a penalty on b · s to the model: by c = s × b, the way b · s goes when s turns.
  void penalize(SymmetricLanes& H, VectorLanes& g, const VectorLanes& s, Lanes penalty) const {
    const VectorLanes c{s.y * b.z - s.z * b.y, s.z * b.x - s.x * b.z, s.x * b.y - s.y * b.x};
    H = plusOuter(H, penalty, c);
    g = g - (penalty * dot(s)) * c;
  }
};

/// A row that is an axis.
template <int kAxis>
struct AxisRow {
  static Lanes dot(const VectorLanes& s) { return kAxis == 0 ? s.x : kAxis == 1 ? s.y : s.z; }
  static void pull(VectorLanes& y, Lanes pull) { (kAxis == 0 ? y.x : kAxis == 1 ? y.y : y.z) += pull; }
  static void penalize(SymmetricLanes& H, VectorLanes& g, const VectorLanes& s, Lanes penalty) {
    const VectorLanes ps = penalty * s;
    if constexpr (kAxis == 0) {
      H.yy += ps.z * s.z, H.yz -= ps.y * s.z, H.zz += ps.y * s.y;
      g.y -= ps.x * s.z, g.z += ps.x * s.y;
    } else if constexpr (kAxis == 1) {
      H.xx += ps.z * s.z, H.xz -= ps.x * s.z, H.zz += ps.x * s.x;
      g.x += ps.y * s.z, g.z -= ps.y * s.x;
    } else {
      H.xx += ps.y * s.y, H.xy -= ps.x * s.y, H.yy += ps.x * s.x;
      g.x -= ps.z * s.y, g.y += ps.z * s.x;
    }
  }
};

/// Visits the rows with their lengths.
struct AnyRows {
  const PolyhedronRows& rows;

  template <typename Visit>
  void forEach(Visit visit) const {
    for (const Row& row : rows) visit(AnyRow{row}, row.length);
  }
};

struct Axes {
  const PolyhedronRows& rows;

  template <typename Visit>
  void forEach(Visit visit) const {
    const Row* const row = rows.begin();
    visit(AxisRow<0>{}, row[0].length);
    visit(AxisRow<1>{}, row[1].length);
    visit(AxisRow<2>{}, row[2].length);
  }
};

/// A −= s yᵀ
void subtractOuter(MatrixLanes& A, const VectorLanes& s, const VectorLanes& y) {
  const Lanes rows[] = {s.x, s.y, s.z}, columns[] = {y.x, y.y, y.z};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) A.m[i][j] -= rows[i] * columns[j];
  }
}

/// H made positive definite in some lanes, where a Newton step would go to no maximum: by Gershgorin's bound of its
/// eigenvalues.
SymmetricLanes shifted(const SymmetricLanes& H, LaneMask lanes) {
  constexpr float kMargin = 0.1f;
  const Lanes xy = absolute(H.xy), xz = absolute(H.xz), yz = absolute(H.yz);
  const Lanes least = minimum(H.xx - xy - xz, minimum(H.yy - xy - yz, H.zz - xz - yz));
  const Lanes size = maximum(absolute(H.xx), maximum(absolute(H.yy), absolute(H.zz)));
  const Lanes shift = keep(lanes, kMargin * size - minimum(least, splat(0)));
  return {H.xx + shift, H.xy, H.xz, H.yy + shift, H.yz, H.zz + shift};
}

/// The climb of four vertices. Everywhere below, kinks go on with the rows of each normal.
template <typename Rows>
class Climb {
 public:
  Climb(const CubicLanes& vertices, const Rows& rows, std::span<KinkLanes> kinks)
      : vertices_(vertices), rows_(rows), kinks_(kinks), stiffness_(kPenalty * largestEntries(vertices.M)) {}

  Climbed run(LaneMask open, QuaternionLanes& rotations);

 private:
  /// R M − Σ_k s_k y_kᵀ with the pulls y_k = κ_k Σ_j l_j u_j b_j; decides what is at its kink in `active` lanes.
  MatrixLanes pulled(const MatrixLanes& R, LaneMask active);
  /// Adds the penalties of kinks to the model.
  void penalize(const MatrixLanes& R, SymmetricLanes& H, VectorLanes& g) const;
  /// Moves the multipliers by what a turn of `share` w leaves of the constraints; returns where all are subgradients.
  LaneMask updateMultipliers(const MatrixLanes& R, const VectorLanes& w, Lanes share, LaneMask active);
  /// κ·|B R n|, kinks left out, and subgradients back into their interval.
  Lanes finish(const MatrixLanes& R);

  const CubicLanes& vertices_;
  const Rows rows_;
  std::span<KinkLanes> kinks_;
  Lanes stiffness_;
};

template <typename Rows>
MatrixLanes Climb<Rows>::pulled(const MatrixLanes& R, LaneMask active) {
  MatrixLanes A = R * vertices_.M;
  KinkLanes* kink = kinks_.data();
  for (const FanLanes& fan : vertices_.fans) {
    const VectorLanes s = R * fan.n;
    VectorLanes y{splat(0), splat(0), splat(0)};
    rows_.forEach([&](const auto& row, float length) {
      Lanes& u = kink->u;
      const Lanes shifted = row.dot(s) + kKink * u, weight = length * fan.weight;
      kink->isActive = select(active, (absolute(shifted) <= kKink) & (weight > 0), kink->isActive);
      u = select(active & ~kink->isActive, withSign(splat(1), shifted), u);
      row.pull(y, weight * u);
      ++kink;
    });
    subtractOuter(A, s, y);
  }
  return A;
}

template <typename Rows>
void Climb<Rows>::penalize(const MatrixLanes& R, SymmetricLanes& H, VectorLanes& g) const {
  const KinkLanes* kink = kinks_.data();
  for (const FanLanes& fan : vertices_.fans) {
    const VectorLanes s = R * fan.n;
    rows_.forEach([&](const auto& row, float) { row.penalize(H, g, s, keep((kink++)->isActive, stiffness_)); });
  }
}

template <typename Rows>
LaneMask Climb<Rows>::updateMultipliers(const MatrixLanes& R, const VectorLanes& w, Lanes share, LaneMask active) {
  LaneMask good = active;
  KinkLanes* kink = kinks_.data();
  for (const FanLanes& fan : vertices_.fans) {
    const VectorLanes s = R * fan.n, after = s + cross(w, s);
    rows_.forEach([&](const auto& row, float length) {
      const Lanes left = row.dot(after), weight = length * fan.weight;
      Lanes& u = kink->u;
      u = select(active & kink->isActive, u + share * stiffness_ * left / weight, u);
      const LaneMask atKink = (absolute(left) <= kAtKink) & (absolute(u) <= 1 + kOutside);
      const LaneMask offKink = (u * left >= -kRounding) | (weight == 0);
      good &= (kink->isActive & atKink) | (~kink->isActive & offKink);
      ++kink;
    });
  }
  return good;
}

template <typename Rows>
Lanes Climb<Rows>::finish(const MatrixLanes& R) {
  Lanes regularizers = splat(0);
  KinkLanes* kink = kinks_.data();
  for (const FanLanes& fan : vertices_.fans) {
    const VectorLanes s = R * fan.n;
    rows_.forEach([&](const auto& row, float length) {
      regularizers += keep(~kink->isActive, length * fan.weight * absolute(row.dot(s)));
      kink->u = minimum(maximum(kink->u, splat(-1)), splat(1));
      ++kink;
    });
  }
  return regularizers;
}

template <typename Rows>
Climbed Climb<Rows>::run(LaneMask open, QuaternionLanes& rotations) {
  LaneMask done{}, valid = ~done, certified = done;
  for (KinkLanes& kink : kinks_) kink.isActive = done;
  const int maxSteps = all(open) ? kMaxOpenSteps : kMaxSteps;
  for (int step = 0; step < maxSteps && any(valid & ~done); ++step) {
    const MatrixLanes R = toMatrix(rotations);
    const RotationModelLanes model(pulled(R, valid & ~done));
    SymmetricLanes H = model.H;
    VectorLanes g = model.g;
    penalize(R, H, g);
    InverseLanes inverse(H);
    if (const LaneMask bent = open & ~inverse.definite; any(bent)) inverse = InverseLanes(shifted(H, bent));
    valid &= inverse.definite | done;
    const LaneMask active = valid & ~done;
    const VectorLanes newton = inverse.inverse * g;
    const Lanes squaredTurn = dot(newton, newton);
    const Lanes share = select(squaredTurn > kLongest * kLongest, kLongest / squareRoot(squaredTurn), splat(1));
    const VectorLanes w = keep(active, share * newton);
    rotations = turned(rotations, keep(squaredTurn > kTurnOfRounding * kTurnOfRounding, w));
    const LaneMask settled = updateMultipliers(R, w, share, active) & (squaredTurn < kConverged);
    const LaneMask proved = settled & isPositiveDefinite(model.H);
    certified |= proved;
    done |= proved | (settled & open);
  }
  const Lanes regularizers = finish(toMatrix(rotations));
  return {regularizers, certified & valid, done & valid};
}

}  // namespace

PolyhedronRows::PolyhedronRows(const Polyhedron& polyhedron)
    : count_(static_cast<std::size_t>(polyhedron.rowCount)), areAxes_(count_ == 3) {
  for (std::size_t j = 0; j < count_; ++j) {
    const Vec3& row = polyhedron.rows[j];
    rows_[j] = {static_cast<float>(row.x()), static_cast<float>(row.y()), static_cast<float>(row.z()),
                static_cast<float>(polyhedron.lengths[j])};
    areAxes_ = areAxes_ && row == Vec3::Unit(static_cast<Index>(j));
  }
}

Lanes PolyhedronRows::regularizers(const CubicLanes& vertices, const QuaternionLanes& rotations) const {
  const MatrixLanes R = toMatrix(rotations);
  Lanes sum = splat(0);
  for (const FanLanes& fan : vertices.fans) {
    const VectorLanes s = R * fan.n;
    for (const Row& row : *this) sum += row.length * fan.weight * absolute(AnyRow{row}.dot(s));
  }
  return sum;
}

Climbed climbPolyhedral(const CubicLanes& vertices, const PolyhedronRows& rows, LaneMask open,
                        std::span<KinkLanes> kinks, QuaternionLanes& rotations) {
  if (rows.areAxes()) return Climb<Axes>(vertices, {rows}, kinks).run(open, rotations);
  return Climb<AnyRows>(vertices, {rows}, kinks).run(open, rotations);
}

}  // namespace whittle
