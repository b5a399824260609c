#pragma once

#include "methods/local_global/cubic/polyhedron.h"

namespace whittle {

/// The global maximum of tr(R M) − κ Σ l_j |b_j · R n| over all rotations where the dual leaves a gap: the best of all
/// that can be a local maximum. Off the great circles b_j · s = 0 of the turned normal s = R n that is one Procrustes
/// fit for each cell between them; on a circle it is sampled and refined, and where two cross there is nothing left to
/// choose. Never worse than `guess`. Some ten microseconds.
Mat3 searchCubic(const PolyhedralVertex& vertex, const Mat3& guess);

}  // namespace whittle
