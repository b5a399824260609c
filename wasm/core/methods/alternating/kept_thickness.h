#pragma once

#include <vector>

#include "methods/alternating/thin_walls.h"

namespace whittle {

/// What became of the thickness of what is thin.
struct ThicknessReport {
  double changedArea = 0;  // as a share of what is thin
  double most = 1;         // the farthest from 1 of times what it was, but for outliers
};

/// Compares thickness before and after, but where handles on both sides ask for another one.
/// @param handles rows of the surface, aimed; positions #V×3
ThicknessReport findChangedThickness(const RestSurface& surface, const std::vector<ThicknessProbe>& probes,
                                     const std::vector<PointRow>& handles, const Points& positions);

}  // namespace whittle
