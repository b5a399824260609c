#pragma once

#include "geometry/edge_set.h"

namespace whittle {

/// A rotation per face: M_f = 2 Σ g_fj x_jᵀ over its corners, b_j = Σ_f R_f g_fj.
class FaceEdges : public EdgeSet {
 public:
  /// `rest` and `halfCotangents` are referred to, not copied: they must outlive the edge set.
  FaceEdges(const TriangleMesh& rest, const CornerScalars& halfCotangents);

  Index elementCount() const override { return triangles_.rows(); }
  double restEnergy() const override { return restEnergy_; }
  double gatherCovariances(const Points& output, ElementRange range, CovarianceLanes* covariances,
                           std::vector<LaneRow>& residual) const override;
  void addSimilar(const std::vector<QuaternionLanes>& rotations, const std::vector<Lanes>& growths, ElementRange range,
                  std::vector<LaneRow>& residual) const override;

 private:
  const Triangles& triangles_;
  const Points& restPositions_;
  const CornerScalars& halfCotangents_;
  std::vector<LaneRow> gradients_;  // 2 #F: g of corners 1 and 2; corner 0 has what makes the sum zero
  double restEnergy_ = 0;           // Σ_f Σ_e c_e |d_e|²
};

}  // namespace whittle
