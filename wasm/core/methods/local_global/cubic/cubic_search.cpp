// Its twin in single precision, a few points for four vertices at a time: search_lanes.cpp.
#include "methods/local_global/cubic/cubic_search.h"

#include <array>
#include <bitset>
#include <cmath>

#include "geometry/rotation_fit.h"
#include "geometry/rotation_newton.h"

namespace whittle {

namespace {

constexpr int kSamples = 48;  // of a great circle, a multiple of 4 so that the axes are among them
constexpr int kGoldenSteps = 45;
constexpr double kParallel = 1e-9;  // radians

/// The objective as a function of the turned normal s alone: the turn about s that is left has its best angle in closed
/// form.
class NormalObjective {
 public:
  explicit NormalObjective(const PolyhedralVertex& vertex)
      : n_(vertex.n), first_(n_.unitOrthogonal()), second_(n_.cross(first_)), ofNormal_(vertex.M.transpose() * n_),
        ofFirst_(vertex.M.transpose() * first_), ofSecond_(vertex.M.transpose() * second_),
        cross_(ofFirst_.cross(ofSecond_)), squares_(ofFirst_.squaredNorm() + ofSecond_.squaredNorm()),
        weight_(vertex.weight), polyhedron_(vertex.polyhedron) {}

  double operator()(const Vec3& s) const {
    const double x = s.dot(ofFirst_), y = s.dot(ofSecond_);
    const double inPlane = squares_ - x * x - y * y + 2 * s.dot(cross_);
    return s.dot(ofNormal_) + std::sqrt(std::max(0.0, inPlane)) - weight_ * polyhedron_.support(s);
  }

  Mat3 rotation(const Vec3& s) const {
    const Vec3 a = s.unitOrthogonal(), b = s.cross(a);
    const double cosine = a.dot(ofFirst_) + b.dot(ofSecond_), sine = b.dot(ofFirst_) - a.dot(ofSecond_);
    const double length = std::hypot(cosine, sine);
    const double c = length > 0 ? cosine / length : 1, d = length > 0 ? sine / length : 0;
    const Mat3 R = (c * a + d * b) * first_.transpose() + (c * b - d * a) * second_.transpose() + s * n_.transpose();
    return orthonormalized(R);
  }

 private:
  Vec3 n_, first_, second_;                     // right-handed
  Vec3 ofNormal_, ofFirst_, ofSecond_, cross_;  // Mᵀ times them
  double squares_;
  double weight_;
  const Polyhedron& polyhedron_;
};

struct Best {
  Vec3 s;
  double value;

  void offer(const Vec3& candidate, double candidateValue) {
    if (candidateValue > value) *this = {candidate, candidateValue};
  }
};

/// The local maximum of `f` between two angles by golden sections, which kinks do not disturb.
template <typename Function>
double localMaximum(const Function& f, double low, double high) {
  const double golden = (std::sqrt(5.0) - 1) / 2;
  double a = high - golden * (high - low), b = low + golden * (high - low);
  double atA = f(a), atB = f(b);
  for (int step = 0; step < kGoldenSteps; ++step) {
    if (atA > atB) {
      high = b, b = a, atB = atA;
      atA = f(a = high - golden * (high - low));
    } else {
      low = a, a = b, atA = atB;
      atB = f(b = low + golden * (high - low));
    }
  }
  return (low + high) / 2;
}

/// All local maxima with b · s = 0. Not inlined: with -msimd128, Clang 14's superword (SLP) vectorizer then computes
/// wrong maxima; the tests of the search show it.
[[gnu::noinline]] void searchCircle(const NormalObjective& objective, const Vec3& b, Best& best) {
  const Vec3 first = b.unitOrthogonal(), second = b.cross(first);
  const auto point = [&](double angle) -> Vec3 { return std::cos(angle) * first + std::sin(angle) * second; };
  const auto value = [&](double angle) { return objective(point(angle)); };
  constexpr double kStep = 2 * EIGEN_PI / kSamples;
  std::array<double, kSamples> samples;
  for (int k = 0; k < kSamples; ++k) samples[k] = value(k * kStep);
  for (int k = 0; k < kSamples; ++k) {
    if (samples[k] < samples[(k + 1) % kSamples] || samples[k] < samples[(k + kSamples - 1) % kSamples]) continue;
    const double angle = localMaximum(value, (k - 1) * kStep, (k + 1) * kStep);
    best.offer(point(angle), value(angle));
  }
}

/// Where the great circles across two unit vectors cross; zero where they are the same circle.
Vec3 crossingOf(const Vec3& a, const Vec3& b) {
  const Vec3 crossing = a.cross(b);
  const double sine = crossing.norm();
  return sine > kParallel ? Vec3(crossing / sine) : Vec3(Vec3::Zero());
}

/// The fit of every cell between the great circles, each once: a cell has a corner where two circles cross, or all rows
/// are parallel.
class CellSearch {
 public:
  CellSearch(const PolyhedralVertex& vertex, const NormalObjective& objective, const Mat3& guess)
      : vertex_(vertex), objective_(objective), guess_(guess) {}

  void run(Best& best) {
    const auto& rows = vertex_.polyhedron.rows;
    for (Index j = 0; j < vertex_.polyhedron.rowCount; ++j) {
      for (const double side : {1, -1}) offerCellAt(side * rows[j], best);
      for (Index i = 0; i < j; ++i) offerCellsAround(rows[i], rows[j], best);
    }
  }

 private:
  static constexpr double kAside = 1e-4;  // radians

  void offerCellsAround(const Vec3& a, const Vec3& b, Best& best) {
    const Vec3 crossing = crossingOf(a, b);
    if (crossing.isZero(0)) return;
    const Vec3 alongA = a.cross(crossing), alongB = b.cross(crossing);
    for (const double side : {1, -1}) {
      for (const double first : {1, -1}) {
        for (const double second : {1, -1})
          offerCellAt(side * crossing + kAside * (first * alongA + second * alongB), best);
      }
    }
  }

  void offerCellAt(const Vec3& direction, Best& best) {
    unsigned pattern = 0;  // of the signs that `pulledAt` sees
    for (Index j = 0; j < vertex_.polyhedron.rowCount; ++j) {
      pattern |= unsigned{!std::signbit(vertex_.polyhedron.rows[j].dot(direction))} << j;
    }
    if (seen_[pattern]) return;
    seen_[pattern] = true;
    const Vec3 s = (fitRotation(vertex_.pulledAt(direction), guess_) * vertex_.n).normalized();
    best.offer(s, objective_(s));
  }

  const PolyhedralVertex& vertex_;
  const NormalObjective& objective_;
  const Mat3& guess_;
  std::bitset<std::size_t{1} << Polyhedron::kMostRows> seen_;
};

}  // namespace

Mat3 searchCubic(const PolyhedralVertex& vertex, const Mat3& guess) {
  const Polyhedron& polyhedron = vertex.polyhedron;
  const NormalObjective objective(vertex);
  Best best{(guess * vertex.n).normalized(), 0};
  best.value = objective(best.s);
  const auto offerBoth = [&](const Vec3& s) {
    if (s.isZero(0)) return;
    best.offer(s, objective(s));
    best.offer(-s, objective(-s));
  };
  for (Index j = 0; j < polyhedron.rowCount; ++j) {
    for (Index i = 0; i < j; ++i) offerBoth(crossingOf(polyhedron.rows[i], polyhedron.rows[j]));
    searchCircle(objective, polyhedron.rows[j], best);
  }
  CellSearch(vertex, objective, guess).run(best);
  return objective.rotation(best.s);
}

}  // namespace whittle
