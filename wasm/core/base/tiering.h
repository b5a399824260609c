#pragma once

/// Marks the body of a long loop that runs once. A browser exchanges its quickly compiled code for its good one only
/// where a function is called, never within one, so what is called per element is soon fast and what loops over all
/// elements stays slow to its end. The compiler must not put the two together again.
#define WHITTLE_OWN_FUNCTION __attribute__((noinline))
