#include "methods/alternating/sphericity.h"

#include <algorithm>
#include <cmath>

namespace whittle {

namespace {

constexpr double kMostCurvature = 2;                                // k_max, of the sphere that fills the unit box
constexpr double kAnisotropySpread = 0.08, kFlatnessSpread = 0.18;  // 2σ², σ = 0.2 and 0.3
constexpr double kMostAnisotropy = 0.5, kLeastRoundness = 0.01;

}  // namespace

Scalars sphericity(const Curvatures& curvatures) {
  Scalars result(curvatures.larger.size());
  for (Index f = 0; f < result.size(); ++f) {
    const double anisotropy = curvatures.anisotropy(f);  // f_iso
    const double roundness = std::min(curvatures.weakest(f), kMostCurvature) / kMostCurvature, flatness = 1 - roundness;
    const bool isSphere = anisotropy <= kMostAnisotropy && roundness > kLeastRoundness;
    result[f] =
        isSphere ? std::exp(-anisotropy * anisotropy / kAnisotropySpread - flatness * flatness / kFlatnessSpread) : 0;
  }
  return result;
}

}  // namespace whittle
