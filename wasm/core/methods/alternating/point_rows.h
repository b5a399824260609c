#pragma once

#include <array>
#include <vector>

#include "base/types.h"

namespace whittle {

/// A quadratic that is the same for x, y and z and does not change from iteration to iteration: stiffness · ‖Σ c v − d‖²
/// over a few vertices. Handles, straight lines, ties between parts and the scaffold are of this kind.
struct PointRow {
  static constexpr int kMost = 6;

  std::array<Index, kMost> vertices{};
  std::array<double, kMost> coefficients{};  // c
  int count = 0;
  double stiffness = 1;
  Vec3 target = Vec3::Zero();  // d

  void add(Index vertex, double coefficient) {
    vertices[count] = vertex;
    coefficients[count++] = coefficient;
  }
  /// Σ c v − d
  Vec3 residual(const Points& positions) const {
    Vec3 sum = -target;
    for (int i = 0; i < count; ++i) sum += coefficients[i] * positions.row(vertices[i]).transpose();
    return sum;
  }
};

}  // namespace whittle
