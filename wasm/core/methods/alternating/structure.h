#pragma once

#include <optional>

#include "constraints/straight_chains.h"
#include "methods/alternating/cylinder_patches.h"
#include "methods/alternating/rest_surface.h"
#include "methods/alternating/thin_walls.h"

namespace whittle {

/// How features are told. Marks are by edge, #E, or empty where there are none.
struct FeatureSettings {
  double angle = 40 * EIGEN_PI / 180;  // radians by which faces bend along a feature
  std::vector<bool> marked;            // features whatever their angle
  std::vector<bool> unmarked;          // none whatever their angle
};

/// What is found on a surface, whatever becomes of it.
struct Structure {
  std::vector<bool> features;  // #E
  Curvatures curvatures;       // #F
  std::vector<CylinderPatch> patches;
  VertexChains straightChains;  // of features
  ThinWalls walls;
};

/// Finds the structure of a surface slice by slice.
class StructureSearch {
 public:
  /// @param surface to be kept by the caller until the end
  StructureSearch(const RestSurface& surface, const FeatureSettings& settings);

  /// Does a slice of some 10 ms; returns the share that is done, 1 at the end.
  double next();
  /// The structure, once all is done.
  Structure take() { return std::move(result_); }

 private:
  const RestSurface& surface_;
  Structure result_;
  CurvatureEstimate estimate_;
  ThinWallSearch walls_;
  double estimated_ = 0, walled_ = 0;
};

}  // namespace whittle
