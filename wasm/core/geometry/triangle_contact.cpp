#include "geometry/triangle_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace whittle {

namespace {

/// Squared sine below which two segments are parallel: they are near each other all along, or nowhere.
constexpr double kParallel = 1e-4;

/// Share of the way from a to b at which p is nearest.
double shareAlong(const Vec3& p, const Vec3& a, const Vec3& b) {
  const double square = (b - a).squaredNorm();
  return square > 0 ? std::clamp((p - a).dot(b - a) / square, 0.0, 1.0) : 0;
}

}  // namespace

Vec3 nearestPoint(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = (b - a).cross(c - a);
  const double square = normal.squaredNorm();
  if (square > 0) {
    const Vec3 inside(normal.dot((c - b).cross(p - b)), normal.dot((a - c).cross(p - c)),
                      normal.dot((b - a).cross(p - a)));
    if (inside.minCoeff() >= 0) return inside / inside.sum();
  }
  // Outside of it, or it has no inside: the nearest of its sides.
  const Vec3* const corners[] = {&a, &b, &c};
  Vec3 best = Vec3::UnitX();
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const Vec3 &from = *corners[k], &to = *corners[(k + 1) % 3];
    const double share = shareAlong(p, from, to);
    const double distance = (p - from - share * (to - from)).squaredNorm();
    if (distance >= least) continue;
    least = distance;
    best.setZero();
    best[k] = 1 - share;
    best[(k + 1) % 3] = share;
  }
  return best;
}

std::optional<Crossing> crossing(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = (b - a).cross(c - a), way = q - p;
  const double across = normal.dot(way);
  if (across == 0) return {};
  const double along = normal.dot(a - p) / across;
  if (!(along >= 0 && along <= 1)) return {};
  const Vec3 at = p + along * way;
  const Vec3 inside(normal.dot((c - b).cross(at - b)), normal.dot((a - c).cross(at - c)),
                    normal.dot((b - a).cross(at - a)));
  if (!(inside.minCoeff() >= 0 && inside.sum() > 0)) return {};
  return Crossing{along, inside / inside.sum()};
}

std::optional<Approach> nearestBetween(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b) {
  const Vec3 first = q - p, second = b - a, between = a - p, normal = first.cross(second);
  const double square = normal.squaredNorm();
  if (square <= kParallel * first.squaredNorm() * second.squaredNorm()) return {};
  const double s = between.cross(second).dot(normal) / square, t = between.cross(first).dot(normal) / square;
  if (!(s > 0 && s < 1 && t > 0 && t < 1)) return {};
  return Approach{s, t, (between + t * second - s * first).norm()};
}

}  // namespace whittle
