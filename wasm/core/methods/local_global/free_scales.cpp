#include "methods/local_global/free_scales.h"

namespace whittle {

namespace {

/// No element shrinks to a point or turns over: of scales from here on the best is taken.
constexpr float kSmallestScale = 1e-3f;
/// A growth below this is rounding and left out, so that what is at rest stays there to the bit.
constexpr float kGrowthOfRounding = 3e-7f;

}  // namespace

void FreeScales::prepare(const EdgeSet& edges, const Scalars& targetWeights) {
  for (Index k = 0; k < targetWeights.size(); ++k) targetWeights_[k / 4][k % 4] = static_cast<float>(targetWeights[k]);
  for (std::size_t b = 0; b < weights_.size(); ++b) {
    const SymmetricLanes& rest = edges.restCovariances()[b];  // 2 Σ c d dᵀ
    weights_[b] = 0.5f * (rest.xx + rest.yy + rest.zz) + targetWeights_[b];
  }
}

Lanes FreeScales::fit(std::size_t batch, Lanes alignmentGains, const MatrixLanes& covariances,
                      MatrixLanes& rotationChanges) {
  const Lanes weight = weights_[batch];
  const Lanes excess = alignmentGains + trace(covariances) - 2 * targetWeights_[batch];  // tr(R M) − 2 w
  // What has no extent has no scale.
  const Lanes best = maximum(keep(weight > 0, excess / (2 * weight)), splat(kSmallestScale - 1));
  const Lanes growth = growths_[batch] = keep(absolute(best) >= kGrowthOfRounding, best);
  for (auto& row : rotationChanges.m) {
    for (Lanes& entry : row) entry += growth * entry;
  }
  for (int i = 0; i < 3; ++i) rotationChanges.m[i][i] += growth;
  return growth * (growth * weight - excess);
}

}  // namespace whittle
