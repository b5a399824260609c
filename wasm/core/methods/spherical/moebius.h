#pragma once

#include "base/types.h"

namespace whittle {

/// The conformal map of the unit sphere to itself that moves it by `c`, |c| < 1: p ↦ (1 − |c|²)(p + c)/|p + c|² + c.
/// It is a rotation-free Möbius transformation; to first order in c it moves p by 2(c − (c·p)p).
Vec3 moebiusBoost(const Vec3& p, const Vec3& c);

/// Chooses among the conformal maps to the sphere, which are one up to a Möbius transformation, the one that is
/// centred: boosts points of the unit sphere (#V×3, in place) until the weights (#V, not negative) balance, Σ w p = 0.
/// That is Newton's method with shortened steps; a weight that outweighs all others together leaves the best it came
/// to.
void balanceOnSphere(const Scalars& weights, Points& points);

/// What is left of a motion d (#V×3) of points p on the unit sphere once its boost is taken out: Σ w |d − (b −
/// (b·p)p)|² / Σ w with the b that makes it least for weights spread evenly over the sphere, or with b = 0 where that
/// is less.
double meanSquareButBoost(const Scalars& weights, const Points& p, const Points& d);

}  // namespace whittle
