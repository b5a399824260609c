#pragma once

#include <span>

#include "base/types.h"

namespace whittle {

/// Numbers that Newton's method has in single and in double precision.
inline constexpr double kLongestTurn = 0.7;  // radians of a step; the model holds no further
inline constexpr double kKinkShare = 0.25;   // of u, which decides whether a coordinate of R n stays at zero

/// One vertex of the cubic local step with one normal (2019, Eq. 3): max_R tr(R M) − Σ_j κ_j |(R n)_j|, κ = λ a on each
/// axis.
struct CubicVertex {
  Mat3 M;
  Vec3 n;        // unit
  Vec3 weights;  // κ, not negative

  double regularizer(const Vec3& s) const { return weights.dot(s.cwiseAbs()); }
  /// M − n (κ∘u)ᵀ: the fit of it is the dual's maximum for a subgradient u.
  Mat3 pulled(const Vec3& u) const { return M - n * weights.cwiseProduct(u).transpose(); }
  double objective(const Mat3& R) const { return R.cwiseProduct(M.transpose()).sum() - regularizer(R * n); }
};

/// A normal of a vertex, of one of its smooth fans.
struct FanNormal {
  Vec3 n;         // unit
  double weight;  // κ = λ a, a the fan's share of the area; zero where there is no normal
};

using FanNormals = std::span<const FanNormal>;

}  // namespace whittle
