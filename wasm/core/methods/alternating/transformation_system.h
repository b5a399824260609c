#pragma once

#include "linear/matrix_field_system.h"
#include "methods/alternating/reshape_energy.h"

namespace whittle {

/// The transformation solve (§4.2, Eq. 24 to 27, 36): the transformations that are best for given positions. The terms
/// are rows in double precision that are never assembled; the matrix that they make does not change from iteration to
/// iteration nor with the handles, and its single precision shadow finds the correction to what a residual leaves.
class TransformationSystem {
 public:
  /// Takes the terms of a surface, which the caller keeps.
  Status shape(const RestSurface& surface, const EnergyWeights& weights);

  /// Moves transformations to the minimum for half edges e, 3#F×3. Allocates nothing.
  /// @returns how many iterations that took
  int solve(const Points& halfEdges, const MatrixFieldSystem::Limits& limits, Transformations& transformations);

  /// The energy of these transformations without the term that ties them to half edges.
  double energy(const Transformations& transformations) const;

 private:
  void addHinges();
  Status setDiagonals();
  void residualOf(const Points& halfEdges, const Transformations& transformations);

  const RestSurface* surface_ = nullptr;
  EnergyWeights weights_;
  MatrixFieldSystem system_;
  std::vector<Mat3> couplingSums_;  // #F, Σ P of each face
  std::vector<Mat3> residual_;      // #F
  std::vector<Mat3> sphericity_;    // #F, scratch of the set-up
  MatrixRows rows_, correction_;
};

}  // namespace whittle
