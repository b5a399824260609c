#include "methods/alternating/gesture.h"

#include <cstddef>

namespace whittle {

namespace {

/// Handles that are farther from a straight continuation of a gesture, as a share of its length, are another gesture.
constexpr double kStraightOn = 0.25;
/// How many times a gesture may be taken.
constexpr double kMostTimes = 3;

}  // namespace

std::optional<double> shareOfGesture(const std::vector<Vec3>& before, const std::vector<Vec3>& now) {
  if (before.size() != now.size()) return std::nullopt;
  double dot = 0, squared = 0, length = 0;
  for (std::size_t h = 0; h < now.size(); ++h) {
    dot += now[h].dot(before[h]);
    squared += before[h].squaredNorm();
    length += now[h].squaredNorm();
  }
  if (dot <= 0 || dot > kMostTimes * squared) return std::nullopt;
  const double times = dot / squared;
  const double off = length - times * dot;
  if (off > kStraightOn * kStraightOn * length) return std::nullopt;
  return times;
}

}  // namespace whittle
