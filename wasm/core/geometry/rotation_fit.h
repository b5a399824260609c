#pragma once

#include "geometry/lane_algebra.h"

namespace whittle {

/// The rotation that maximises tr(R M) (orthogonal Procrustes, det R = +1), from the singular value decomposition of M.
/// Right for every finite matrix, reflected and rank-deficient ones included; the yardstick of the faster fits.
Mat3 fitRotation(const Mat3& M);

/// The same rotation, found by Newton's method on SO(3) from a rotation near it. Where the Hessian tr(A) I − sym(A),
/// A = R M, is not positive definite (which certifies the global maximum) or Newton is slow, falls back on `fitRotation`.
Mat3 fitRotation(const Mat3& M, const Mat3& guess);

/// Four covariances scaled to a size of about 1, where single precision neither overflows nor underflows, and the scale that was
/// taken off. Matrices of zeros stay.
struct ScaledCovariances {
  MatrixLanes M;
  Lanes scale;

  explicit ScaledCovariances(const CovarianceLanes& covariances);
};

/// Four rotations at once in single precision (about 1e-7 radians), by the same method from `rotations`, which are
/// updated. Lanes without a certificate fall back on `fitRotation`.
void fitRotations(const ScaledCovariances& covariances, QuaternionLanes& rotations);

}  // namespace whittle
