#pragma once

#include "methods/local_global/cubic/cubic_solver.h"
#include "methods/local_global/cubic/polyhedral_lanes.h"
#include "methods/local_global/cubic/search_schedule.h"

namespace whittle {

/// The local step for any polyhedron and any number of normals, exactly: four vertices at a time. What that does not
/// certify goes to `searchCubic`, or where there are several normals is climbed again from many rotations around the plain
/// fit; how often, `SearchSchedule` says.
class PolyhedralExact : public CubicSolver {
 public:
  explicit PolyhedralExact(const Polyhedron& polyhedron) : polyhedron_(polyhedron), rows_(polyhedron) {}

  void begin(const FanLayout& layout) override;
  Lanes solve(std::size_t batch, const CubicLanes& vertices, QuaternionLanes& rotations) override;

 private:
  // Both look for better rotations in some lanes and return those where there were.
  LaneMask search(const CubicLanes& vertices, LaneMask lanes, const QuaternionLanes& before, std::span<KinkLanes> kinks,
                  QuaternionLanes& rotations, Lanes& regularizers);
  /// @param known lanes that were searched before
  LaneMask climbAgain(const CubicLanes& vertices, LaneMask lanes, LaneMask known, std::span<KinkLanes> kinks,
                      QuaternionLanes& rotations, Lanes& regularizers);

  Polyhedron polyhedron_;
  PolyhedronRows rows_;
  const FanLayout* layout_ = nullptr;
  std::vector<KinkLanes> kinks_;    // of each row for the first normal of the first batch, then for the second, …
  std::vector<KinkLanes> attempt_;  // of one batch
  std::vector<FanNormal> normals_;  // scratch
  SearchSchedule schedule_;
};

}  // namespace whittle
