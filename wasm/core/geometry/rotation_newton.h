#pragma once

#include <Eigen/LU>

#include "base/types.h"

namespace whittle {

/// First and second order of tr(exp([w]×) A) in w: gradient g and negative Hessian H = tr(A) I − sym(A). Where g = 0 and H is
/// positive definite, the rotation in A is the global maximum, not only a local one.
struct RotationModel {
  Vec3 g;
  Mat3 H;

  explicit RotationModel(const Mat3& A)
      : g(A(1, 2) - A(2, 1), A(2, 0) - A(0, 2), A(0, 1) - A(1, 0)),
        H(A.trace() * Mat3::Identity() - 0.5 * (A + A.transpose())) {}
};

/// Below `singular` of its trace's powers the determinant counts as zero.
inline bool isPositiveDefinite(const Mat3& H, double singular = 1e-6) {
  const double trace = H.trace();
  const double minor = H(0, 0) * H(1, 1) - H(0, 1) * H(1, 0);
  return trace > 0 && H(0, 0) > 0 && minor > 0 && H.determinant() > singular * trace * trace * trace;
}

/// The rotation (I − ½[w]×)⁻¹ (I + ½[w]×): by angle 2 atan(|w|/2) about w, equal to exp([w]×) to third order.
inline Mat3 cayley(const Vec3& w) {
  const Vec3 v = 0.5 * w;
  const double s = 1 / (1 + v.squaredNorm());
  Mat3 cross;
  cross << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return (2 * s) * (v * v.transpose() + cross) + (2 * s - 1) * Mat3::Identity();
}

/// One Newton step of the polar decomposition: takes off the rounding that a product of many rotations collects.
inline Mat3 orthonormalized(const Mat3& R) { return 0.5 * R * (3 * Mat3::Identity() - R.transpose() * R); }

}  // namespace whittle
