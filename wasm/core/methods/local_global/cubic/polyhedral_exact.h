#pragma once

#include "methods/local_global/cubic/cubic_solver.h"
#include "methods/local_global/cubic/polyhedral_lanes.h"

namespace whittle {

/// The local step for any polyhedron, exactly: four vertices at a time; what that does not certify goes to
/// `searchCubic`.
class PolyhedralExact : public CubicSolver {
 public:
  explicit PolyhedralExact(const Polyhedron& polyhedron) : polyhedron_(polyhedron) {}

  void begin(std::size_t batches) override { subgradients_.assign(batches, SubgradientLanes{}); }
  Lanes solve(std::size_t batch, const CubicLanes& vertices, QuaternionLanes& rotations) override;

 private:
  Polyhedron polyhedron_;
  std::vector<SubgradientLanes> subgradients_;
};

}  // namespace whittle
