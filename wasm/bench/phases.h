#pragma once

#include "bench/measure.h"
#include "bench/problem.h"

namespace whittle::bench {

/// Times the phases of preparing and of an iteration, core and yardstick by turns; medians in ms.
Json measurePhases(const Problem& problem, double seconds);

}  // namespace whittle::bench
