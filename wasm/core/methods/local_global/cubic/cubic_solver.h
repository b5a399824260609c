#pragma once

#include <vector>

#include "methods/local_global/cubic/cubic_lanes.h"
#include "methods/local_global/cubic/cubic_vertex.h"
#include "methods/local_global/fan_layout.h"

namespace whittle {

/// The cubic local step of four vertices, warm from the call before.
class CubicSolver {
 public:
  virtual ~CubicSolver() = default;

  /// Forgets what earlier calls left. @param layout outlives the solver's use
  virtual void begin(const FanLayout& layout) = 0;

  /// Updates the rotations; returns the regularizers κ·|R n|. Allocates nothing.
  virtual Lanes solve(std::size_t batch, const CubicLanes& vertices, QuaternionLanes& rotations) = 0;
};

/// The normals of one of four vertices, in `normals` (as many as the batch has; those that it has not weigh nothing).
inline FanNormals normalsAt(const CubicLanes& vertices, int lane, std::vector<FanNormal>& normals) {
  for (std::size_t k = 0; k < vertices.fans.size(); ++k) {
    const FanLanes& fan = vertices.fans[k];
    normals[k] = {vectorAt(fan.n, lane).normalized(), fan.weight[lane]};
  }
  return {normals.data(), vertices.fans.size()};
}

}  // namespace whittle
