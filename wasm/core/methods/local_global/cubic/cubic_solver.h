#pragma once

#include <vector>

#include "methods/local_global/cubic/cubic_lanes.h"
#include "methods/local_global/cubic/cubic_vertex.h"

namespace whittle {

/// The cubic local step of four vertices, warm from the call before.
class CubicSolver {
 public:
  virtual ~CubicSolver() = default;

  /// Forgets what earlier calls left.
  virtual void begin(std::size_t batches) = 0;

  /// Updates the rotations; returns the regularizers κ·|R n|. Allocates nothing.
  virtual Lanes solve(std::size_t batch, const CubicLanes& vertices, QuaternionLanes& rotations) = 0;
};

inline CubicVertex vertexAt(const CubicLanes& vertices, int lane) {
  const auto& [M, n, weights] = vertices;
  return {matrixAt(M, lane), vectorAt(n, lane).normalized(), vectorAt(weights, lane)};
}

}  // namespace whittle
