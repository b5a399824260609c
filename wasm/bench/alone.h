#pragma once

#include "bench/measure.h"
#include "bench/problem.h"

namespace whittle::bench {

/// Times a method that has no plain path beside it, in ms: from the loaded mesh to ready, first in a fresh process and
/// then again, an iteration (median), a run to its own end or until `seconds` are over; and its energies.
Json measureAlone(const Problem& problem, double seconds);

}  // namespace whittle::bench
