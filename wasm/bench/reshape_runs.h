#pragma once

#include "bench/measure.h"
#include "mesh/triangle_mesh.h"

namespace whittle::bench {

/// Times reshaping on the gestures of `gestures.h` at about so many faces, in ms: each from the loaded mesh in a session
/// of its own to ready, to the first picture and to the final result, the first of all in a fresh process; an iteration
/// as printed beside the plain one for some seconds, and the ways to solve its systems, where there are no more faces
/// than the plain one can do (`reshape_solvers.h`).
Json measureReshape(Index faces, double seconds);

}  // namespace whittle::bench
