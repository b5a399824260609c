#pragma once

#include "linear/matrix_field_system.h"
#include "methods/alternating/reshape_energy.h"

namespace whittle {

/// The transformation solve (§4.2, Eq. 24 to 27, 36): the transformations that are best for given positions. The terms
/// are rows in double precision that are never assembled; the matrix that they make does not change from iteration to
/// iteration nor with the handles, and its single precision shadow finds the correction to what a residual leaves.
class TransformationSystem {
 public:
  /// Begins to take the terms of a surface, which the caller keeps; `prepareNext` does it slice by slice. Fails with
  /// `numericalFailure`.
  void shape(const RestSurface& surface, const EnergyWeights& weights);
  Status prepareNext(double& share);

  /// Begins to move transformations, which the caller keeps, to the minimum for half edges e, 3#F×3; `solveNext` does it
  /// slice by slice and returns whether all is done. Neither allocates.
  void beginSolve(const Points& halfEdges, const MatrixFieldSystem::Limits& limits, Transformations& transformations);
  bool solveNext();

  /// The energy of these transformations without the term that ties them to half edges.
  double energy(const Transformations& transformations) const;

 private:
  void addHinges();
  Status setDiagonal(Index face);
  void residualOf(const Points& halfEdges, const Transformations& transformations);

  const RestSurface* surface_ = nullptr;
  EnergyWeights weights_;
  MatrixFieldSystem system_;
  std::vector<Mat3> couplingSums_;  // #F, Σ P of each face
  std::vector<Mat3> residual_;      // #F
  Index nextFace_ = 0;              // whose diagonal block is to be set
  MatrixRows rows_, correction_;
  Transformations* solved_ = nullptr;  // while a solve goes on
};

}  // namespace whittle
