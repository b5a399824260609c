#pragma once

#include "simd/lane_algebra.h"

namespace whittle {

/// Four vertices of the cubic local step, in single precision. A vertex without cubeness or without a normal has no
/// weights.
struct CubicLanes {
  MatrixLanes M;
  VectorLanes n;
  VectorLanes weights;  // κ
};

/// The regularizers κ·|R n|, and the lanes whose result is certified to single precision.
struct Climbed {
  Lanes regularizers;
  LaneMask certified;
};

/// The semismooth Newton method of `CubicExact` on four vertices, from rotations and subgradients that are updated.
/// Where it is certified, coordinates of R n at a kink are zero but for rounding.
Climbed climbLanes(const CubicLanes& vertices, VectorLanes& subgradients, QuaternionLanes& rotations);

}  // namespace whittle
