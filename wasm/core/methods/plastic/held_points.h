#pragma once

#include <vector>

#include "base/types.h"

namespace whittle {

/// What points that stay where they are leave of a body's freedom.
struct HeldPoints {
  enum class Rank { none, point, line, plane };

  Rank rank = Rank::none;
  Vec3 center = Vec3::Zero();     // mean of the points
  Vec3 direction = Vec3::Zero();  // of the line

  explicit HeldPoints(const std::vector<Vec3>& points);
};

}  // namespace whittle
