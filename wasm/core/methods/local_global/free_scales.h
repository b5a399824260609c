#pragma once

#include "methods/local_global/edges/edge_set.h"

namespace whittle {

/// The scales s_k of Σ_k Σ_e c_e |s_k R_k d_e − u_e|² + a_k |s_k R_k n_k − t_k|². For the best R_k the energy of an
/// element is a parabola in s, w s² − tr(R M) s + const with w = Σ_e c_e |d_e|² + a |n|², and s its lowest point (the
/// printed one, with nᵀt in place of these, is not; see the sheet, §4).
class FreeScales {
 public:
  /// Claims memory for so many elements, all of scale 1.
  explicit FreeScales(Index elementCount)
      : weights_(batchCount(elementCount), splat(0)), targetWeights_(weights_), growths_(weights_) {}

  /// @param targetWeights a_k |n_k|², one number per element, or empty for none
  void prepare(const EdgeSet& edges, const Scalars& targetWeights);

  /// Scales of four elements whose rotations are found, in changes like everything: makes s R − I of the rotation
  /// changes R − I. Returns what the scales change in the energy.
  /// @param alignmentGains tr((R − I) M)
  /// @param covariances M − M⁰, the target term included
  Lanes fit(std::size_t batch, Lanes alignmentGains, const MatrixLanes& covariances, MatrixLanes& rotationChanges);

  /// Copies the scales s_k of the last fit, one number per element.
  void copyTo(Scalars& scales) const {
    for (Index k = 0; k < scales.size(); ++k) scales[k] = 1 + static_cast<double>(growths_[k / 4][k % 4]);
  }

 private:
  std::vector<Lanes> weights_;        // w
  std::vector<Lanes> targetWeights_;  // a |n|²
  std::vector<Lanes> growths_;        // s − 1
};

}  // namespace whittle
