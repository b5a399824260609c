#include "geometry/rotation_fit.h"

#include <Eigen/SVD>

#include "geometry/rotation_newton.h"

namespace whittle {

namespace {

constexpr int kMaxNewtonSteps = 8;
/// |w|² below which the step just taken has left an error of about that size, whose square is what the gain feels.
constexpr double kConverged = 1e-10;

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
    const RotationModel model(R * M);
    if (!isPositiveDefinite(model.H)) return fitRotation(M);
    const Vec3 w = model.H.inverse() * model.g;
    R = cayley(w) * R;
    if (w.squaredNorm() < kConverged) return orthonormalized(R);
  }
  return fitRotation(M);
}

}  // namespace whittle
