#pragma once

#include <array>
#include <vector>

#include "base/types.h"

namespace whittle {

/// A quadratic that does not change from iteration to iteration but for a straight line's: stiffness · ‖Σ c v − d‖² over
/// a few vertices, in all directions, along one or across it. Handles, straight lines, walls, ties between parts and the
/// scaffold are of this kind.
struct PointRow {
  static constexpr int kMost = 6;
  enum class Counts { everywhere, along, across };

  std::array<Index, kMost> vertices{};
  std::array<double, kMost> coefficients{};  // c
  int count = 0;
  double stiffness = 1;
  Vec3 target = Vec3::Zero();  // d
  Counts counts = Counts::everywhere;
  Vec3 direction = Vec3::Zero();  // unit, along or across which alone it counts
  /// Of a straight line's row: half edges along it, after its middle vertex and before, or −1 where there are none.
  /// Coefficients are 1 / l₊, −1 / l₊ − 1 / l₋ and 1 / l₋ for their present lengths, so that a line may stretch unevenly.
  std::array<Index, 2> halfEdges = {-1, -1};

  void add(Index vertex, double coefficient) {
    vertices[count] = vertex;
    coefficients[count++] = coefficient;
  }
  bool isOfLine() const { return halfEdges[0] >= 0; }
  void setLineLengths(double after, double before) { coefficients = {1 / after, -1 / after - 1 / before, 1 / before}; }

  /// The matrix of what counts of a residual.
  Mat3 metric() const {
    if (counts == Counts::everywhere) return Mat3::Identity();
    const Mat3 along = direction * direction.transpose();
    return counts == Counts::along ? along : Mat3(Mat3::Identity() - along);
  }
  /// Σ c v − d
  Vec3 residual(const Points& positions) const {
    Vec3 sum = -target;
    for (int i = 0; i < count; ++i) sum += coefficients[i] * positions.row(vertices[i]).transpose();
    return sum;
  }
};

}  // namespace whittle
