#pragma once

#include "methods/local_global/edges/edge_set.h"

namespace whittle {

/// A rotation per face: M′_f = 2 Σ g_fj δ_jᵀ over its corners, b_j = Σ_f R_f g_fj.
class FaceEdges : public EdgeSet {
 public:
  FaceEdges(const TriangleMesh& rest, const CornerScalars& halfCotangents);

  int visits() const override { return 1; }
  double gatherCovariances(const LaneRows& displacements, ElementRange range, MatrixLanes* covariances,
                           LaneRows& residual) const override;
  void addRotationChanges(const MatrixLanes* rotationChanges, ElementRange range, LaneRows& residual) const override;

 protected:
  void collect(ElementRange range) override;

 private:
  /// Four faces; zeros for what fills up the last batch.
  struct Faces {
    RowIndices corners[3];
    Lanes weights[3];          // c of the edges opposite to the corners; zero of stiff edges
    VectorLanes gradients[2];  // g of corners 1 and 2; corner 0 has what makes the sum zero
  };

  const TriangleMesh& rest_;
  const CornerScalars& halfCotangents_;
  std::vector<Faces> faces_;
};

}  // namespace whittle
