#pragma once

#include <vector>

#include "base/types.h"

namespace whittle {

/// The way of landmarks that are turned far: a screw motion in legs of at most 60°, and what is beside it evenly along the
/// way. Straight to their targets they would have to pass through its axis.
class TurnPath {
 public:
  /// No way: one leg, which ends at the targets.
  TurnPath() = default;
  /// @param turn how far they turn in all, in radians, which their targets tell but for whole turns; 0: the least
  TurnPath(const std::vector<Vec3>& points, const std::vector<Vec3>& targets, double turn);

  int legs() const { return legs_; }
  /// Where a landmark is to be at the end of a leg, from 1 to `legs`.
  Vec3 target(std::size_t landmark, int leg) const;

 private:
  int legs_ = 1;
  double angle_ = 0, pitch_ = 0;
  Vec3 axis_ = Vec3::UnitZ(), center_ = Vec3::Zero();
  std::vector<Vec3> points_, targets_, beside_;
};

}  // namespace whittle
