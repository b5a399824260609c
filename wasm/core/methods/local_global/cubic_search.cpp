#include "methods/local_global/cubic_search.h"

#include <array>
#include <cmath>

#include "geometry/rotation_fit.h"
#include "geometry/rotation_newton.h"

namespace whittle {

namespace {

constexpr int kSamples = 48;  // of a great circle, a multiple of 4 so that the axes are among them
constexpr int kGoldenSteps = 45;

/// The objective as a function of the turned normal s alone: the turn about s that is left has its best angle in closed form.
class NormalObjective {
 public:
  explicit NormalObjective(const CubicVertex& vertex)
      : n_(vertex.n),
        first_(n_.unitOrthogonal()),
        second_(n_.cross(first_)),
        ofNormal_(vertex.M.transpose() * n_),
        ofFirst_(vertex.M.transpose() * first_),
        ofSecond_(vertex.M.transpose() * second_),
        cross_(ofFirst_.cross(ofSecond_)),
        squares_(ofFirst_.squaredNorm() + ofSecond_.squaredNorm()),
        weights_(vertex.weights) {}

  double operator()(const Vec3& s) const {
    const double x = s.dot(ofFirst_), y = s.dot(ofSecond_);
    const double inPlane = squares_ - x * x - y * y + 2 * s.dot(cross_);
    return s.dot(ofNormal_) + std::sqrt(std::max(0.0, inPlane)) - weights_.dot(s.cwiseAbs());
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
  Vec3 n_, first_, second_;                   // right-handed
  Vec3 ofNormal_, ofFirst_, ofSecond_, cross_;  // Mᵀ times them
  double squares_;
  Vec3 weights_;
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

/// All local maxima with s_j = 0. Not inlined: with -msimd128, Clang 14's superword (SLP) vectorizer then computes wrong
/// maxima; the tests of the search show it.
[[gnu::noinline]] void searchCircle(const NormalObjective& objective, Index j, Best& best) {
  const auto point = [j](double angle) {
    Vec3 s = Vec3::Zero();
    s[(j + 1) % 3] = std::cos(angle);
    s[(j + 2) % 3] = std::sin(angle);
    return s;
  };
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

}  // namespace

Mat3 searchCubic(const CubicVertex& vertex, const Mat3& guess) {
  const NormalObjective objective(vertex);
  Best best{(guess * vertex.n).normalized(), 0};
  best.value = objective(best.s);
  for (Index axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) best.offer(sign * Vec3::Unit(axis), objective(sign * Vec3::Unit(axis)));
  }
  for (int octant = 0; octant < 8; ++octant) {
    const Vec3 u(octant & 1 ? 1 : -1, octant & 2 ? 1 : -1, octant & 4 ? 1 : -1);
    const Vec3 s = (fitRotation(vertex.pulled(u), guess) * vertex.n).normalized();
    best.offer(s, objective(s));
  }
  for (Index j = 0; j < 3; ++j) searchCircle(objective, j, best);
  return objective.rotation(best.s);
}

}  // namespace whittle
