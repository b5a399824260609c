#include "methods/local_global/free_scales.h"

#include <algorithm>
#include <cmath>

namespace whittle {

namespace {

/// No element shrinks to a point or turns over: of scales from here on the best is taken.
constexpr double kSmallestScale = 1e-3;
/// A growth below this is rounding and left out, so that what is at rest stays there to the bit.
constexpr double kGrowthOfRounding = 1e-13;

}  // namespace

void FreeScales::prepare(const EdgeSet& edges, const Points& rest, const Scalars& pullWeights) {
  std::vector<CovarianceLanes> covariances(weights_.size(), CovarianceLanes{});
  std::vector<LaneRow> residual(rest.rows());
  edges.gatherCovariances(rest, edges.allElements(), covariances.data(), residual);
  for (std::size_t b = 0; b < weights_.size(); ++b) weights_[b] = 0.5 * traces(identityRotations(), covariances[b]);
  for (Index k = 0; k < pullWeights.size(); ++k) weights_[k / 4][k % 4] += pullWeights[k];
}

double FreeScales::fit(std::size_t batch, DoubleLanes traces) {
  double change = 0;
  for (int lane = 0; lane < 4; ++lane) {
    const double weight = weights_[batch][lane], trace = traces[lane];
    // What has no extent has no scale.
    const double growth = weight > 0 ? std::max(trace / (2 * weight) - 1, kSmallestScale - 1) : 0;
    growths_[batch][lane] = std::abs(growth) < kGrowthOfRounding ? 0.0f : static_cast<float>(growth);
    const double rounded = growths_[batch][lane];
    change += rounded * ((2 + rounded) * weight - trace);
  }
  return change;
}

}  // namespace whittle
