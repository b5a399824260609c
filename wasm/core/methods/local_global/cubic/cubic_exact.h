#pragma once

#include "methods/local_global/cubic/polyhedral_exact.h"

namespace whittle {

/// The cubic local step solved exactly: a semismooth Newton method for the rotation R and the subgradient u ∈ ∂|R n|₁
/// at once, without parameters. Its result is certified: where u·R n = |R n|₁ and R maximises tr(R (M − n (κ∘u)ᵀ)), the
/// dual min_u max_R has no gap and R is the global maximum. Four vertices at a time in single precision; the few that
/// are not certified so are solved again in double. What has a true gap is searched, for λ above 3, where gaps become the
/// rule, at some points of where its maximum can lie.
class CubicExact : public CubicSolver {
 public:
  /// @param axes what the box takes κ times on each axis
  explicit CubicExact(const Vec3& axes = Vec3::Ones()) : axes_(axes), several_(Polyhedron::box(axes)) {}

  void begin(const FanLayout& layout) override;
  Lanes solve(std::size_t batch, const CubicLanes& vertices, QuaternionLanes& rotations) override;

  /// One vertex in double precision from a rotation R and a guess u, both updated. Never worse than the R given.
  /// Returns whether Newton's method certified the result; where it did not, all that can be the maximum is searched.
  static bool solveCertified(const CubicVertex& vertex, Vec3& u, Mat3& R);

 private:
  /// Newton's method alone, from R and from the dual's side.
  static bool certify(const CubicVertex& vertex, Vec3& u, Mat3& R);
  /// Looks in some lanes for what is better than the last answer and what was climbed from there.
  static void search(const MatrixLanes& M, const VectorLanes& n, const VectorLanes& weights, LaneMask lanes,
                     const QuaternionLanes& before, VectorLanes& u, QuaternionLanes& rotations, Lanes& regularizers);

  Vec3 axes_;
  std::vector<VectorLanes> subgradients_;  // u, of each batch
  std::vector<LaneMask> gaps_;             // lanes that could not be certified in the call before
  PolyhedralExact several_;                // for batches in which a vertex has several normals
};

}  // namespace whittle
