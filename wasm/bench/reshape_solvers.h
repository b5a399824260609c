#pragma once

#include "bench/gestures.h"
#include "bench/measure.h"
#include "methods/alternating/rest_surface.h"
#include "reference/plain_reshape.h"

namespace whittle::bench {

/// A gesture in its unit frame.
Gesture inUnitFrame(Gesture gesture);
/// The surface of a mesh with the terms as printed, and the plain alternation on it.
RestSurface printedSurface(const TriangleMesh& mesh);
PlainReshape plainOn(const RestSurface& surface, const Handles& handles);

/// Beyond so many faces a factor of the transformations takes minutes and gigabytes.
constexpr Index kMostPlainFaces = 30000;

/// Times the ways to solve the two systems of the alternation at its third iteration, in ms. Transformations: a
/// factorization in blocks of 9, or conjugate gradients. Vertices: a factorization of the
/// first matrix in blocks of 3, or of the mean of its axes, each as preconditioner of the third matrix, to 1e-3 of what
/// is left.
Json measureSolvers(const Gesture& gesture);

}  // namespace whittle::bench
