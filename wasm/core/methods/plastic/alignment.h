#pragma once

#include <vector>

#include "base/types.h"

namespace whittle {

/// x → center + turn (x − center) + shift.
struct RigidMotion {
  Mat3 turn = Mat3::Identity();
  Vec3 center = Vec3::Zero();
  Vec3 shift = Vec3::Zero();

  Vec3 operator()(const Vec3& x) const { return center + turn * (x - center) + shift; }
};

/// The rigid motion that brings points nearest to their targets while those that are held stay where they are: none where
/// these span a plane, a turn about their line or about the one point, or any motion. Where points leave a turn open the
/// least is taken.
RigidMotion alignment(const std::vector<Vec3>& held, const std::vector<Vec3>& points, const std::vector<Vec3>& targets);

}  // namespace whittle
