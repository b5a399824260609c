#pragma once

#include <vector>

#include "methods/local_global/cubic_vertex.h"

namespace whittle {

/// The cubic local step solved exactly: a semismooth Newton method for the rotation R and the subgradient u ∈ ∂|R n|₁ at
/// once, without parameters. Its result is certified: where u·R n = |R n|₁ and R maximises tr(R (M − κ n uᵀ)), the dual
/// min_u max_R has no gap and R is the global maximum. What cannot be certified (the dual has a gap, mostly for λ above 3)
/// goes to `searchCubic`, warm start included, so the objective never falls.
class CubicExact : public CubicVertexSolver {
 public:
  void begin(const Scalars& weights) override { subgradients_.assign(weights.size(), Vec3::Zero()); }
  void solve(Index vertex, const Mat3& M, const Vec3& n, double weight, Mat3& R) override {
    solveCertified(M, n, weight, subgradients_[vertex], R);
  }

  /// One vertex from a rotation R and a guess u, both updated. Returns whether Newton's method certified the result.
  static bool solveCertified(const Mat3& M, const Vec3& n, double weight, Vec3& u, Mat3& R);

 private:
  std::vector<Vec3> subgradients_;  // u
};

}  // namespace whittle
