#pragma once

#include "base/types.h"

namespace whittle {

/// One vertex of the cubic local step (2019, Eq. 3): max_R tr(R M) − κ |R n|₁ with κ = λ a, warm from the call before.
class CubicVertexSolver {
 public:
  virtual ~CubicVertexSolver() = default;

  /// Forgets what earlier calls left. @param weights #V, κ
  virtual void begin(const Scalars& weights) = 0;

  /// Updates R, a rotation on entry. n is of unit length and κ positive. Allocates nothing.
  virtual void solve(Index vertex, const Mat3& M, const Vec3& n, double weight, Mat3& R) = 0;
};

/// tr(R M) − κ |R n|₁
inline double cubicObjective(const Mat3& M, const Vec3& n, double weight, const Mat3& R) {
  return R.cwiseProduct(M.transpose()).sum() - weight * (R * n).lpNorm<1>();
}

}  // namespace whittle
