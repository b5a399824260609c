#include "methods/plastic/held_points.h"

namespace whittle {

namespace {

/// Points that are off a line by a smaller share of its length are on it.
constexpr double kOnLine = 1e-6;
/// Points no farther apart, in a unit in which the whole shape is 100 long, are one.
constexpr double kOnePoint = 1e-7;

}  // namespace

HeldPoints::HeldPoints(const std::vector<Vec3>& points) {
  if (points.empty()) return;
  for (const Vec3& point : points) center += point / static_cast<double>(points.size());
  Vec3 far = Vec3::Zero();
  for (const Vec3& point : points) {
    if ((point - center).squaredNorm() > far.squaredNorm()) far = point - center;
  }
  const double length = far.norm();
  double off = 0;
  if (length > kOnePoint) {
    direction = far / length;
    for (const Vec3& point : points) off = std::max(off, direction.cross(point - center).norm());
  }
  rank = length <= kOnePoint ? Rank::point : off <= kOnLine * length ? Rank::line : Rank::plane;
  if (rank == Rank::point) center = points.front();
}

}  // namespace whittle
