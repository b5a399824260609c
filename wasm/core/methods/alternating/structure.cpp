#include "methods/alternating/structure.h"

#include "methods/alternating/bevels.h"

namespace whittle {

namespace {

std::vector<bool> featuresOf(const RestSurface& surface, const FeatureSettings& settings) {
  std::vector<bool> features = featureEdges(surface.pairs, surface.edges.count(), settings.angle);
  for (std::size_t e = 0; e < settings.marked.size(); ++e) {
    if (settings.marked[e]) features[e] = true;
  }
  for (std::size_t e = 0; e < settings.unmarked.size(); ++e) {
    if (settings.unmarked[e]) features[e] = false;
  }
  return features;
}

}  // namespace

StructureSearch::StructureSearch(const RestSurface& surface, const FeatureSettings& settings)
    : surface_(surface), result_{featuresOf(surface, settings), {}, {}, {}, {}},
      estimate_(surface.mesh.positions, surface.mesh.triangles, surface.edges, result_.features), walls_(surface) {}

double StructureSearch::next() {
  constexpr double kCurvature = 0.6, kWalls = 0.3;  // shares of the work
  if (estimated_ < 1) {
    estimated_ = estimate_.next();
    return kCurvature * estimated_;
  }
  if (walled_ < 1) {
    walled_ = walls_.next();
    return kCurvature + kWalls * walled_;
  }
  result_.walls = walls_.take();
  result_.curvatures = estimate_.take();
  result_.patches = cylinderPatches(surface_.mesh, surface_.pairs, result_.features, result_.curvatures);
  for (CylinderPatch& bevel : bevels(surface_.mesh, surface_.pairs)) result_.patches.push_back(std::move(bevel));
  result_.straightChains = straightChains(surface_.mesh.positions, surface_.edges, result_.features);
  return 1;
}

}  // namespace whittle
