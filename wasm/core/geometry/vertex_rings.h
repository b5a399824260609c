#pragma once

#include "geometry/edge_set.h"

namespace whittle {

/// Spokes and rims in ring form: Ĝ_kj = ⅓ Σ g_fj over the faces f that k and j share, so that M_k = 6 Σ_j Ĝ_kj (x_j − x_k)ᵀ and
/// b_j = Σ_k R_k Ĝ_kj, over the ring of each vertex.
class VertexRings : public EdgeSet {
 public:
  VertexRings(const TriangleMesh& rest, const CornerScalars& halfCotangents);

  Index elementCount() const override { return static_cast<Index>(start_.size()) - 1; }
  double restEnergy() const override { return restEnergy_; }
  double gatherCovariances(const Points& output, ElementRange range, CovarianceLanes* covariances,
                           std::vector<LaneRow>& residual) const override;
  void addSimilar(const std::vector<QuaternionLanes>& rotations, const std::vector<Lanes>& growths, ElementRange range,
                  std::vector<LaneRow>& residual) const override;

 private:
  typedef double Pair __attribute__((vector_size(16)));

  /// Ĝ_kj is never longer than the edges around it: single precision will do.
  struct alignas(16) Spoke {
    float x, y, z;
    Index neighbour;  // j
  };

  /// Σ_j Ĝ_kj (x_j − x_k)ᵀ, row by row, and as a fourth row Σ_j w_kj (x_j − x_k) = −L V, at a vertex. Packed so that no half of a
  /// pair is wasted: x and y of each row, z of two rows.
  struct RingSums {
    Pair xy[4], z[2];

    Vec3 pull() const { return {xy[3][0], xy[3][1], z[1][1]}; }
  };

  RingSums sumRing(const Points& output, Index k) const;
  /// The first three rows of four vertices, times what makes them covariances, one vertex a lane.
  static void storeCovariances(const RingSums* sums, CovarianceLanes& covariances);
  void collectRings(const TriangleMesh& rest, const CornerScalars& halfCotangents);

  std::vector<Index> start_;     // #V + 1
  std::vector<Spoke> spokes_;    // ring by ring
  std::vector<double> weights_;  // w_kj = Σ c, as in the Laplacian; those of thin faces are huge and cancel
  Points restPull_;              // #V×3, −L V₀
  double restEnergy_ = 0;        // Σ_k Σ_e c_e |d_e|²
};

}  // namespace whittle
