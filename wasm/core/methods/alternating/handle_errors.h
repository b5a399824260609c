#pragma once

#include "base/status.h"
#include "methods/alternating/reshape_energy.h"

namespace whittle {

/// Spreads what a handle has bent next to it over four rings of faces (App. A, "Finalizing outputs"): where the faces
/// at a handle have turned by more than 10°, and by more than twice as much as those four rings away. Everything else
/// stays where it is.
/// @param rows of the run; the first `handleCount` are the handles
/// @param handleStiffness their weight meanwhile
/// @returns whether there was such a handle; positions are then changed. Fails with `numericalFailure`.
Status spreadHandleErrors(const RestSurface& surface, const EnergyWeights& weights,
                          const Transformations& transformations, const std::vector<PointRow>& rows, Index handleCount,
                          double handleStiffness, Points& positions, bool& isSpread);

}  // namespace whittle
