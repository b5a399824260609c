#pragma once

#include <vector>

#include "methods/alternating/cylinder_patches.h"
#include "methods/alternating/rest_surface.h"

namespace whittle {

/// Round parts and bevels that were to keep their size and do not, within 3 %.
struct SizeReport {
  Index changed = 0;
  double most = 1;  // the size that is farthest off, as a multiple of that at rest
};

/// Measures by how much parts are stretched across their axes, the mean over each by area: a cylinder by its radius, a
/// bevel by its width.
/// @param kept one flag a patch; positions of the surface's vertices, #V×3
SizeReport findChangedSizes(const RestSurface& surface, const std::vector<CylinderPatch>& patches,
                            const std::vector<bool>& kept, const Points& positions);

}  // namespace whittle
