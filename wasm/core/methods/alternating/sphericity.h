#pragma once

#include "geometry/curvature.h"

namespace whittle {

/// Γ: how much each face counts as part of a sphere (#F, 0 … 1), by its curvatures in the unit frame, where a sphere
/// that fills the box has 2. It is 1 where both are 2 and more, falls as they differ and as they get small, and is 0 on
/// everything flat, cylindrical or saddle-shaped: the small rest that the formula leaves on planes would hold them
/// conformal.
Scalars sphericity(const Curvatures& curvatures);

}  // namespace whittle
