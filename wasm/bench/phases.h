#pragma once

#include "bench/measure.h"
#include "bench/problem.h"

namespace whittle::bench {

/// Times the phases of preparing and of an iteration, core and reference by turns, and how many times as fast the core
/// is: medians over rounds, in ms. `seconds` is for each of the two.
Json measurePhases(const Problem& problem, double seconds);

}  // namespace whittle::bench
