#pragma once

#include "simd/lane_algebra.h"

namespace whittle {

/// Rotations of four vertices of one normal each from where a climb may end at a better maximum than from `rotations`:
/// where the dual has a gap the best R n lies on a coordinate plane, so of some points of the three great circles there
/// the one with the greatest objective, and with it the best turn that is left. No maxima themselves.
/// @param weights κ on each axis
QuaternionLanes searchLanes(const MatrixLanes& M, const VectorLanes& n, const VectorLanes& weights,
                            const QuaternionLanes& rotations);

}  // namespace whittle
