#pragma once

#include "base/status.h"
#include "base/types.h"

namespace whittle {

/// Numbers from 0 to 1 over the sphere of directions, as a picture of it: equirectangular, twice as wide as high, y up.
/// The centre of the pixel in column i and row j, rows from the top, is the direction (sin θ sin φ, cos θ, sin θ cos φ)
/// with θ = π (j + ½) / height and φ = 2π ((i + ½) / width − ½): z in the middle, x to the right of it. Between centres
/// it is bilinear, across the left and right edge as everywhere, and over the poles.
struct SphereField {
  static constexpr Index kLeastHeight = 2, kMostHeight = 1024;

  Index height = 0;
  Scalars values;  // width·height, rows from the top

  Index width() const { return 2 * height; }
  /// @param direction of any length but zero
  double operator()(const Vec3& direction) const;

 private:
  double at(Index row, Index column) const;
};

bool operator==(const SphereField& a, const SphereField& b);

/// Fails with `badParameter` where the picture has another shape or a value (element: its place) is not from 0 to 1.
Status validateSphereField(const SphereField& field, Index width);

}  // namespace whittle
