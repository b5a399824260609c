#pragma once

#include "geometry/edge_set.h"

namespace whittle {

/// Spokes and rims in ring form: Ĝ_kj = ⅓ Σ g_fj over the faces f that k and j share, so that M_k = 6 Σ_j Ĝ_kj (x_j − x_k)ᵀ and
/// b_j = Σ_k R_k Ĝ_kj, over the ring of each vertex.
class VertexRings : public EdgeSet {
 public:
  VertexRings(const TriangleMesh& rest, const CornerScalars& halfCotangents);

  Index elementCount() const override { return static_cast<Index>(start_.size()) - 1; }
  double gatherCovariances(const Points& output, std::vector<CovarianceLanes>& covariances,
                           std::vector<LaneRow>& residual) const override;
  void addSimilar(const std::vector<QuaternionLanes>& rotations, const std::vector<Lanes>& growths,
                  std::vector<LaneRow>& residual) const override;

 private:
  typedef double Pair __attribute__((vector_size(16)));

  /// Ĝ_kj is never longer than the edges around it: single precision will do.
  struct alignas(16) Spoke {
    float x, y, z;
    Index neighbour;  // j
  };

  /// Σ_j Ĝ_kj (x_j − x_k)ᵀ, row by row, and Σ_j w_kj (x_j − x_k) = −L V at a vertex, as two overlapping pairs of columns.
  struct RingSums {
    Pair xy[4], yz[4];

    Vec3 pull() const { return {xy[3][0], xy[3][1], yz[3][1]}; }
  };

  RingSums sumRing(const Points& output, Index k) const;
  void collectRings(const TriangleMesh& rest, const CornerScalars& halfCotangents);

  std::vector<Index> start_;     // #V + 1
  std::vector<Spoke> spokes_;    // ring by ring
  std::vector<double> weights_;  // w_kj = Σ c, as in the Laplacian; those of thin faces are huge and cancel
  Points restPull_;              // #V×3, −L V₀
  double restEnergy_ = 0;        // Σ_k Σ_e c_e |d_e|²
};

}  // namespace whittle
