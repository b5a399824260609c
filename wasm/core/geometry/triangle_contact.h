#pragma once

#include <optional>

#include "base/types.h"

namespace whittle {

/// Barycentric coordinates of the point of a triangle that is nearest to p.
Vec3 nearestPoint(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

/// Where a segment goes through a triangle.
struct Crossing {
  double along;  // from the first end, 0, to the other, 1
  Vec3 weights;  // barycentric coordinates in the triangle
};

/// The crossing of the segment from p to q with a triangle; none where they are parallel or miss each other.
std::optional<Crossing> crossing(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c);

/// Where two segments are nearest to each other, as shares of the way along each.
struct Approach {
  double alongFirst, alongSecond;
  double distance;
};

/// The approach of the segments pq and ab; none where they are nearest at an end of one, or parallel.
std::optional<Approach> nearestBetween(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b);

}  // namespace whittle
