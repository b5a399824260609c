#pragma once

#include <span>

#include "simd/lane_algebra.h"

namespace whittle {

/// A normal of each of four vertices, of one of their smooth fans.
struct FanLanes {
  VectorLanes n;  // unit, or zero
  Lanes weight;   // κ = λ a, a the fan's share of the area; zero without cubeness, without a normal, without a fan
};

/// Four vertices of the cubic local step, in single precision.
struct CubicLanes {
  MatrixLanes M;
  std::span<const FanLanes> fans;  // one at least; more where one of the four has more
};

/// The regularizers κ·|R n|, the lanes whose result is certified to single precision, and those that are at a maximum,
/// certified or not.
struct Climbed {
  Lanes regularizers;
  LaneMask certified, settled;
};

/// The semismooth Newton method of `CubicExact` on four vertices of one normal each, from rotations and subgradients
/// that are updated. Where it is certified, coordinates of R n at a kink are zero but for rounding.
/// @param weights κ on each axis
/// @param open lanes that need no certificate
Climbed climbLanes(const MatrixLanes& M, const VectorLanes& n, const VectorLanes& weights, LaneMask open,
                   VectorLanes& subgradients, QuaternionLanes& rotations);

/// Takes another result in the lanes where it is better than what is there, by more than rounding; returns them.
LaneMask takeBetter(const MatrixLanes& M, const QuaternionLanes& other, Lanes otherRegularizers,
                    QuaternionLanes& rotations, Lanes& regularizers);

}  // namespace whittle
