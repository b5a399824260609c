#pragma once

#include "methods/local_global/cubic/cubic_solver.h"

namespace whittle {

/// The cubic local step solved exactly: a semismooth Newton method for the rotation R and the subgradient u ∈ ∂|R n|₁
/// at once, without parameters. Its result is certified: where u·R n = |R n|₁ and R maximises tr(R (M − n (κ∘u)ᵀ)), the
/// dual min_u max_R has no gap and R is the global maximum. Four vertices at a time in single precision; the few that
/// are not certified so are solved again in double, and what has a true gap (mostly for λ above 3) goes to
/// `searchCubic`.
class CubicExact : public CubicSolver {
 public:
  void begin(std::size_t batches) override { subgradients_.assign(batches, {splat(0), splat(0), splat(0)}); }
  Lanes solve(std::size_t batch, const CubicLanes& vertices, QuaternionLanes& rotations) override;

  /// One vertex in double precision from a rotation R and a guess u, both updated. Never worse than the R given.
  /// Returns whether Newton's method certified the result.
  static bool solveCertified(const CubicVertex& vertex, Vec3& u, Mat3& R);

 private:
  std::vector<VectorLanes> subgradients_;  // u
};

}  // namespace whittle
