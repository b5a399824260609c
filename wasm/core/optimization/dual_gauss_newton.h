#pragma once

#include "base/status.h"
#include "base/types.h"

namespace whittle {

/// The step of a Gauss–Newton method for few residuals and many unknowns q, of which a quadratic form keeps: it minimizes
/// |r + J (q − q₀) + G ω|² + qᵀ A q over q and over unknowns ω that nothing keeps. Solved in the residuals, by Woodbury's
/// identity: with W = A⁻¹ Jᵀ the result is q = W λ.
struct DualStep {
  Scalars multipliers;  // λ, what the linear model leaves of the residuals, negated
  Scalars free;         // ω
};

/// @param JW J A⁻¹ Jᵀ, symmetric but for rounding
/// @param target J q₀ − r
/// @param G #residuals×#free, or without columns; columns on which no residual depends, or not on their own, get none of ω
/// @returns `numericalFailure` where numbers are not finite
Status solveDual(const Eigen::MatrixXd& JW, const Scalars& target, const Eigen::MatrixXd& G, DualStep& step);

}  // namespace whittle
