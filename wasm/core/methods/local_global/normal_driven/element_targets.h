#pragma once

#include "methods/local_global/local_step.h"
#include "methods/local_global/rigidity.h"
#include "simd/lane_algebra.h"

namespace whittle {

/// What every element (a vertex, or a face for FARAP) pays for its distance from a target normal, λ a_k |s_k R_k n_k −
/// t_k|² (2021, Eq. 3). That is linear in the rotation: a term of the covariance, M_k += 2 λ a_k n_k t_kᵀ.
class ElementTargets {
 public:
  /// Takes the elements of the rest shape, without targets yet; those without a normal never have one.
  /// @param lambda λ of all elements
  /// @param ownLambdas λ of each vertex in its place (#V), of a face the mean of its corners; or empty
  void prepare(const RestShape& rest, Rigidity rigidity, double lambda, const Scalars& ownLambdas = {});

  Index count() const { return static_cast<Index>(strengths_.size()); }
  /// n_k, #elements×3, unit or zero.
  const Points& normals() const { return normals_; }
  /// λ a_k, zero for elements without a normal.
  const Scalars& strengths() const { return strengths_; }
  /// Sets t_k, a unit vector.
  void set(Index k, const Vec3& target);

  /// Adds the term of four elements to their covariances.
  void addTerm(std::size_t batch, MatrixLanes& covariances) const;
  /// Σ λ a_k |n_k − t_k|², the energy of the rest shape.
  double energy() const { return energy_; }

 private:
  Points normals_;
  Scalars strengths_;
  Scalars energies_;  // λ a_k |n_k − t_k|²
  double energy_ = 0;
  std::vector<VectorLanes> normalLanes_;      // n_k
  std::vector<VectorLanes> weightedTargets_;  // 2 λ a_k t_k
};

/// The local step of all methods that draw normals to targets: the plain fit with the target term.
class TargetedLocalStep : public LocalStep {
 public:
  void addTargetTerm(std::size_t batch, MatrixLanes& covariances) const override {
    targets_.addTerm(batch, covariances);
  }
  double targetEnergy() const override { return targets_.energy(); }
  Scalars targetWeights() const override { return targets_.strengths(); }
  Lanes fit(std::size_t batch, const MatrixLanes& covariances, bool neverWorse, QuaternionLanes& rotations) override;

 protected:
  ElementTargets targets_;
};

}  // namespace whittle
