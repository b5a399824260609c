#include "geometry/rotation_fit.h"

#include <Eigen/LU>
#include <Eigen/SVD>

namespace whittle {

namespace {

constexpr int kMaxNewtonSteps = 8;
/// |w|² below which the step just taken has left an error below rounding (Newton's error is at most squared).
constexpr double kConverged = 1e-16;
/// Below this share of its trace's powers the Hessian counts as singular.
constexpr double kSingular = 1e-6;

/// First and second order of tr(exp([w]×) A) in w: gradient g and negative Hessian H.
struct Model {
  Vec3 g;
  Mat3 H;

  explicit Model(const Mat3& A)
      : g(A(1, 2) - A(2, 1), A(2, 0) - A(0, 2), A(0, 1) - A(1, 0)),
        H(A.trace() * Mat3::Identity() - 0.5 * (A + A.transpose())) {}

  bool positiveDefinite() const {
    const double trace = H.trace();
    const double minor = H(0, 0) * H(1, 1) - H(0, 1) * H(1, 0);
    return trace > 0 && H(0, 0) > 0 && minor > 0 && H.determinant() > kSingular * trace * trace * trace;
  }
};

/// The rotation (I − ½[w]×)⁻¹ (I + ½[w]×): by angle 2 atan(|w|/2) about w, equal to exp([w]×) to third order.
Mat3 cayley(const Vec3& w) {
  const Vec3 v = 0.5 * w;
  const double s = 1 / (1 + v.squaredNorm());
  Mat3 cross;
  cross << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return (2 * s) * (v * v.transpose() + cross) + (2 * s - 1) * Mat3::Identity();
}

/// One Newton step of the polar decomposition: takes off the rounding that a product of many rotations collects.
Mat3 orthonormalized(const Mat3& R) { return 0.5 * R * (3 * Mat3::Identity() - R.transpose() * R); }

}  // namespace

Mat3 fitRotation(const Mat3& M) {
  const Eigen::JacobiSVD<Mat3> svd(M, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Mat3 U = svd.matrixU();
  if ((svd.matrixV() * U.transpose()).determinant() < 0) U.col(2) *= -1;  // turn the least singular direction
  return svd.matrixV() * U.transpose();
}

Mat3 fitRotation(const Mat3& M, const Mat3& guess) {
  Mat3 R = guess;
  for (int step = 0; step < kMaxNewtonSteps; ++step) {
    const Model model(R * M);
    if (!model.positiveDefinite()) return fitRotation(M);
    const Vec3 w = model.H.inverse() * model.g;
    R = cayley(w) * R;
    if (w.squaredNorm() < kConverged) return orthonormalized(R);
  }
  return fitRotation(M);
}

}  // namespace whittle
