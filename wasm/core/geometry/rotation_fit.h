#pragma once

#include "simd/lane_algebra.h"

namespace whittle {

/// The rotation that maximises tr(R M) (orthogonal Procrustes, det R = +1), from the singular value decomposition of M.
/// Right for every finite matrix, reflected and rank-deficient ones included; what the faster fits are held against.
Mat3 fitRotation(const Mat3& M);

/// That rotation again, found by Newton's method on SO(3) from a rotation near it. Where the Hessian tr(A) I − sym(A),
/// A = R M, is not positive definite (which certifies the global maximum) or Newton is slow, falls back on
/// `fitRotation`.
Mat3 fitRotation(const Mat3& M, const Mat3& guess);

/// Four rotations at once in single precision (about 1e-7 radians), by the same method from `rotations`, which are
/// updated. Lanes without a certificate, those of matrices too large or small for single precision among them (about
/// 1e12, 1e-13), fall back on `fitRotation`.
void fitRotations(const MatrixLanes& M, QuaternionLanes& rotations);

}  // namespace whittle
