#pragma once

#include "base/types.h"

namespace whittle {

/// The frame in which every solver works: longest side of the box 1, vertex mean at the origin. In it λ, tolerances and
/// thresholds mean the same whatever the file's units.
struct UnitFrame {
  Vec3 center = Vec3::Zero();
  double scale = 1;  // file units per unit length

  /// The frame of #V×3 positions that `validate` has let through.
  static UnitFrame of(const Points& positions);

  Vec3 toUnit(const Vec3& point) const { return (point - center) / scale; }
  Vec3 toFile(const Vec3& point) const { return center + scale * point; }
};

}  // namespace whittle
