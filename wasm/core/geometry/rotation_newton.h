#pragma once

#include <Eigen/LU>

#include "simd/lane_algebra.h"

namespace whittle {

/// First and second order of tr(exp([w]×) A) in w: gradient g and negative Hessian H = tr(A) I − sym(A). Where g = 0
/// and H is positive definite, the rotation in A is the global maximum, not only a local one.
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

/// `RotationModel` four at a time; the two are twins.
struct RotationModelLanes {
  VectorLanes g;
  SymmetricLanes H;

  explicit RotationModelLanes(const MatrixLanes& A) {
    const auto& m = A.m;
    const Lanes half = splat(0.5f);
    g = {m[1][2] - m[2][1], m[2][0] - m[0][2], m[0][1] - m[1][0]};
    H = {m[1][1] + m[2][2], -half * (m[0][1] + m[1][0]), -half * (m[0][2] + m[2][0]),
         m[0][0] + m[2][2], -half * (m[1][2] + m[2][1]), m[0][0] + m[1][1]};
  }
};

/// A turn (radians) below which single precision sees only its own rounding: it is left out, so that what is at rest
/// stays there.
constexpr float kTurnOfRounding = 3e-7f;

inline LaneMask isPositiveDefinite(const SymmetricLanes& H, Lanes determinant, float singular = 1e-6f) {
  const Lanes trace = H.xx + H.yy + H.zz;
  return (trace > 0) & (H.xx > 0) & (H.xx * H.yy - H.xy * H.xy > 0) &
         (determinant > singular * (trace * trace * trace));
}

inline LaneMask isPositiveDefinite(const SymmetricLanes& H) {
  const Lanes x = H.yy * H.zz - H.yz * H.yz, y = H.xz * H.yz - H.xy * H.zz, z = H.xy * H.yz - H.xz * H.yy;
  return isPositiveDefinite(H, H.xx * x + H.xy * y + H.xz * z);
}

/// H⁻¹ by the adjugate, and in which lanes H is positive definite. In the others the inverse is not to be used.
struct InverseLanes {
  SymmetricLanes inverse;
  LaneMask definite;

  explicit InverseLanes(const SymmetricLanes& H) {
    const Lanes xx = H.yy * H.zz - H.yz * H.yz, xy = H.xz * H.yz - H.xy * H.zz, xz = H.xy * H.yz - H.xz * H.yy;
    const Lanes yy = H.xx * H.zz - H.xz * H.xz, yz = H.xy * H.xz - H.xx * H.yz, zz = H.xx * H.yy - H.xy * H.xy;
    const Lanes determinant = H.xx * xx + H.xy * xy + H.xz * xz;
    definite = isPositiveDefinite(H, determinant);
    const Lanes s = splat(1) / determinant;
    inverse = {s * xx, s * xy, s * xz, s * yy, s * yz, s * zz};
  }
};

}  // namespace whittle
