#pragma once

#include <vector>

#include "geometry/rotation_fit.h"
#include "geometry/smooth_fans.h"
#include "mesh/triangle_mesh.h"

namespace whittle {

/// What a local step may know of the rest shape; everything in the unit frame.
struct RestShape {
  const TriangleMesh& mesh;
  Scalars areas;   // #V, barycentric
  Points normals;  // #V×3, unit or zero
  SmoothFans fans;
};

/// The policy of a local/global method: how each element's rotation is chosen. What belongs to its parameters stands in
/// `LocalStepPolicy`.
class LocalStep {
 public:
  virtual ~LocalStep() = default;

  /// Forgets what earlier iterations left.
  virtual void begin() {}

  /// Whether the energy itself depends on the positions through what `observe` sees. It may then rise, and one
  /// iteration's energy says nothing about another's: iterations are plain ones, without acceleration and without
  /// rejections.
  virtual bool followsOutput() const { return false; }
  /// Whether a run that ends above the energy which it began with is to give its best iterate instead; for energies that
  /// are meant to fall all the same.
  virtual bool keepsBest() const { return false; }
  /// Looks at the positions to which the next rotations are fitted. Allocates nothing.
  virtual void observe(const Points&) {}

  /// Adds what is linear in the (scaled) rotations, −tr(R P) summed over elements, as 1·P to the covariances of four
  /// elements.
  virtual void addTargetTerm(std::size_t, MatrixLanes&) const {}
  /// The part of the energy that belongs to it where nothing is turned, Σ_k a_k |n_k − t_k|².
  virtual double targetEnergy() const { return 0; }
  /// a_k |n_k|² of every element: what a scale s_k makes of it is s_k² as much. Empty: none.
  virtual Scalars targetWeights() const { return {}; }

  /// Finds the rotations R of four elements that are best for their covariances M (tr(R M) is to be large), starting
  /// from those given. Returns their regularizers. Allocates nothing.
  /// @param neverWorse whether no rotation may be worse than it was, where the policy does not promise that anyway
  virtual Lanes fit(std::size_t batch, const MatrixLanes& covariances, bool neverWorse, QuaternionLanes& rotations) = 0;
};

}  // namespace whittle
