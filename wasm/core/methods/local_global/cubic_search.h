#pragma once

#include "methods/local_global/cubic_vertex.h"

namespace whittle {

/// The global maximum of tr(R M) − κ·|R n| over all rotations where the dual leaves a gap: the best of all that can be a local
/// maximum. Within an octant of the turned normal s = R n that is one Procrustes fit; where a coordinate of s is zero it lies on
/// a great circle, which is sampled and refined, its corners being the axes. Never worse than `guess`. Some microseconds.
Mat3 searchCubic(const CubicVertex& vertex, const Mat3& guess);

}  // namespace whittle
