#include "methods/alternating/reshape_terms.h"

#include <algorithm>
#include <cmath>

#include "methods/alternating/sphericity.h"

namespace whittle {

namespace {

/// Half of what a rod of five sides bends by at its edges, and more than one of six: below it edges are smooth.
constexpr double kSmoothBelow = 65 * EIGEN_PI / 180;
constexpr double kLeastSimilarity[kRungs] = {0.01, 0.1, 1};

}  // namespace

ReshapeTerms ReshapeTerms::of(Variant variant, Reading reading, Rung rung) {
  ReshapeTerms terms;
  const bool isTuned = reading == Reading::tuned;
  terms.weakHandles = isTuned ? 1e5 : 1e2;
  terms.weights.keptRadius = 0;
  if (variant == Variant::alup) {
    terms.weights = {.normal = 1, .similarity = 0, .scale = 0, .keptRadius = 0};
    terms.spheres = Spheres::everywhere;
  } else if (isTuned) {
    terms.meanNormalsBelow = kSmoothBelow;
    terms.leastSimilarity = kLeastSimilarity[static_cast<int>(rung)];
    terms.keepsRadii = rung != Rung::none;
    terms.weights.keptRadius = terms.keepsRadii ? 1 : 0;
  }
  return terms;
}

void setTerms(const ReshapeTerms& terms, const Structure& structure, const std::vector<bool>& keptPatches,
              RestSurface& surface) {
  using Spheres = ReshapeTerms::Spheres;
  const Curvatures& curvatures = structure.curvatures;
  setEdgeNormals(surface, terms.meanNormalsBelow);
  setSimilarity(surface);
  if (terms.leastSimilarity < 1) fadeSimilarity(surface, curvatures, terms.leastSimilarity);
  switch (terms.spheres) {
    case Spheres::none: surface.sphericity.setZero(); break;
    case Spheres::found: surface.sphericity = sphericity(curvatures); break;
    case Spheres::everywhere: surface.sphericity.setOnes(); break;
  }
  surface.keptDirections.setZero();
  if (!terms.keepsRadii) return;
  for (std::size_t p = 0; p < structure.patches.size(); ++p) {
    if (!keptPatches[p]) continue;
    const CylinderPatch& patch = structure.patches[p];
    for (const Index f : patch.faces) {
      const Vec3 normal = surface.faceNormals.row(f).transpose();
      surface.keptDirections.row(f) = patch.axis.cross(normal).stableNormalized().transpose();
    }
  }
  fadeBorders(surface, curvatures, terms.leastSimilarity);
}

}  // namespace whittle
