#pragma once

#include "methods/local_global/edges/edge_set.h"

namespace whittle {

/// Spokes and rims in ring form: Ĝ_kj = ⅓ Σ g_fj over the faces f that k and j share, so that M′_k = 6 Σ_j Ĝ_kj (δ_j −
/// δ_k)ᵀ and b_j = Σ_k R_k Ĝ_kj, over the ring of each vertex.
class SpokesAndRims : public EdgeSet {
 public:
  SpokesAndRims(const TriangleMesh& rest, const CornerScalars& halfCotangents);
  ~SpokesAndRims() override;

  int visits() const override { return 3; }  // those of the corners of each face
  double gatherCovariances(const LaneRows& displacements, ElementRange range, MatrixLanes* covariances,
                           LaneRows& residual) const override;
  void addRotationChanges(const MatrixLanes* rotationChanges, ElementRange range, LaneRows& residual) const override;

 protected:
  void collect(ElementRange range) override;
  void endCollecting() override;

 private:
  class RingCollector;

  /// One neighbour j of each of four vertices k. Where a ring is at its end before the others, k itself with zeros.
  /// Ĝ_kj is never longer than the edges around it.
  struct Spokes {
    VectorLanes gradients;  // Ĝ_kj
    Lanes weights;          // w_kj = Σ c, as in the Laplacian; zero of stiff edges
    RowIndices neighbours;  // j
  };

  std::unique_ptr<RingCollector> collector_;  // until all is collected
  std::vector<Index> start_;                  // #batches + 1, into `spokes_`
  std::vector<Spokes> spokes_;
};

}  // namespace whittle
