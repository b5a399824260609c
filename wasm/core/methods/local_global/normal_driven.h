#pragma once

#include <memory>

#include "methods/local_global/local_step.h"
#include "methods/method.h"

namespace whittle {

/// The local step of Normal-Driven Spherical Shape Analogies (2021, Eq. 3 and §4.1): every element (a vertex, or a face for FARAP) pays
/// λ a_k |s_k R_k n_k − t_k|² for its distance from the target normal t_k that the style's Gauss map has for it. That is linear in
/// the rotation: a term of the covariance, M_k += 2 λ a_k n_k t_kᵀ, and a plain fit.
///
/// Targets are those of the rest shape's normals, or (dynamic, §4.2) of the output's, looked up anew in every iteration.
class NormalDriven : public LocalStep {
 public:
  Rigidity rigidity(const Settings& settings) const override;
  Status prepare(const RestShape& rest, const Settings& settings) override;
  bool followsOutput() const override { return isDynamic_; }
  void observe(const Points& positions) override;
  void pull(std::size_t batch, CovarianceLanes& covariances) const override;
  double pullEnergy() const override { return pullEnergy_; }
  Scalars pullWeights() const override { return strengths_; }
  Lanes fit(std::size_t batch, const ScaledCovariances& covariances, bool neverWorse, QuaternionLanes& rotations) override;

 private:
  struct WideVectors {
    DoubleLanes x, y, z;
  };

  void prepareStrengths(const RestShape& rest, const Settings& settings);
  /// Looks the targets of the present normals up; what has no normal keeps the target that it has.
  void lookUpTargets();

  std::shared_ptr<const GaussMap> style_;
  const Triangles* triangles_ = nullptr;
  Rigidity rigidity_ = Rigidity::arap;
  bool isDynamic_ = false;
  Scalars strengths_;                 // λ a_k, zero for elements without a normal
  double pullEnergy_ = 0;             // Σ λ a_k (|n_k|² + |t_k|²), of unit vectors
  std::vector<WideVectors> normals_;  // n_k of the rest shape
  std::vector<WideVectors> pulls_;    // 2 λ a_k t_k
  Points present_;                    // normals that the targets are those of, #elements×3
  Scalars scratch_;                   // #V
};

/// Registry line of the method `analogy`.
MethodInfo analogyMethod();

}  // namespace whittle
