#pragma once

#include "simd/lane_algebra.h"

namespace whittle {

/// Eigenvalues and unit eigenvectors of four symmetric 3×3 matrices, the largest first.
struct EigenLanes {
  Lanes values[3];
  VectorLanes vectors[3];
};

/// Decomposes by Jacobi's rotations in single precision, to about 1e-6 of the largest value: square roots only, so the same bits
/// everywhere, and vectors stay orthonormal where values coincide. A is of a size that single precision holds squares
/// of.
EigenLanes eigenDecomposition(SymmetricLanes A);

}  // namespace whittle
