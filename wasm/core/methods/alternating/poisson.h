#pragma once

#include "methods/alternating/vertex_system.h"
#include "methods/method.h"

namespace whittle {

/// Poisson deformation, the plain one: edge vectors stay as they are as far as handles let them, Σ ‖e − ē‖² / L_avg.
/// One linear solve.
class PoissonRun {
 public:
  /// @param surface to be kept by the caller
  void shape(const RestSurface& surface, std::vector<PointRow> rows);
  Status prepareNext(double& share) { return system_.prepareNext(share); }
  /// Other targets for the first rows.
  void aim(const std::vector<Vec3>& targets);
  Status step(StepReport& report);
  const Points& positions() const { return positions_; }

 private:
  const RestSurface* surface_ = nullptr;
  VertexSystem system_;
  Points positions_;
};

}  // namespace whittle
