#pragma once

#include "methods/local_global/fan_layout.h"
#include "methods/local_global/local_step.h"
#include "methods/local_global/rigidity.h"
#include "simd/lane_algebra.h"
#include "targets/sphere_field.h"

namespace whittle {

/// What every element (a vertex, or a face for FARAP) pays for its distance from a target normal, λ a_k |s_k R_k n_k −
/// t_k|² (2021, Eq. 3). That is linear in the rotation: a term of the covariance, M_k += 2 λ a_k n_k t_kᵀ. A vertex may
/// have a normal and a target for each of its smooth fans; it then has the sum of their terms.
class ElementTargets {
 public:
  /// Takes the elements of the rest shape with one normal each, without targets yet; those without a normal never have
  /// one.
  /// @param lambda λ of all elements
  /// @param ownLambdas λ of each vertex in its place (#V), of a face the mean of its corners; or empty
  void prepare(const RestShape& rest, Rigidity rigidity, double lambda, const Scalars& ownLambdas = {});
  /// Takes the vertices with a normal for each smooth fan.
  void prepareFans(const RestShape& rest, double lambda, const Scalars& ownLambdas = {});
  /// Leaves of λ what the field says of each normal. Targets come after it.
  void weaken(const SphereField& field);

  /// How many normals there are: of all elements, or of all fans.
  Index count() const { return static_cast<Index>(strengths_.size()); }
  /// n_k, #normals×3, unit or zero.
  const Points& normals() const { return normals_; }
  /// λ a_k, zero for those without a normal.
  const Scalars& strengths() const { return strengths_; }
  /// Σ λ a_k of each element.
  Scalars elementStrengths() const;
  /// Sets t_k, a unit vector.
  void set(Index k, const Vec3& target);

  /// Adds the term of four elements to their covariances.
  void addTerm(std::size_t batch, MatrixLanes& covariances) const;
  /// Σ λ a_k |n_k − t_k|², the energy of the rest shape.
  double energy() const { return energy_; }

 private:
  void takeNormals();
  void forgetTargets();

  /// A normal of each of four elements.
  struct Slot {
    VectorLanes normal;          // n_k
    VectorLanes weightedTarget;  // 2 λ a_k t_k
  };

  Points normals_;
  Scalars strengths_;
  Scalars energies_;  // λ a_k |n_k − t_k|²
  double energy_ = 0;
  FanLayout layout_;
  Index elementCount_ = 0;
  std::vector<Slot> slots_;
};

/// The local step of all methods that draw normals to targets: the plain fit with the target term.
class TargetedLocalStep : public LocalStep {
 public:
  void addTargetTerm(std::size_t batch, MatrixLanes& covariances) const override {
    targets_.addTerm(batch, covariances);
  }
  double targetEnergy() const override { return targets_.energy(); }
  Scalars targetWeights() const override { return targets_.elementStrengths(); }
  Lanes fit(std::size_t batch, const MatrixLanes& covariances, bool neverWorse, QuaternionLanes& rotations) override;

 protected:
  ElementTargets targets_;
};

}  // namespace whittle
