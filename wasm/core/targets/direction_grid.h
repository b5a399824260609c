#pragma once

#include <vector>

#include "base/types.h"

namespace whittle {

/// The sphere of directions cut into cells, six faces of a cube with a square grid on each, and in each cell a list of
/// candidates. What a direction asks for is then found among a few, at any density.
class DirectionGrid {
 public:
  /// @param side cells along an edge of the cube
  explicit DirectionGrid(int side = 1);

  int cellCount() const { return 6 * side_ * side_; }
  /// The cell of a direction of any length but zero.
  int cellOf(const Vec3& n) const;
  /// Unit direction of a cell's middle.
  Vec3 middle(int cell) const { return middles_[cell]; }
  /// Angle from there to its furthest corner, radians.
  double radius(int cell) const { return radii_[cell]; }

  /// Adds to `cells` all that a triangle of three unit vectors can reach (its central projection), and a few more at
  /// most.
  void cellsOf(const Mat3& corners, std::vector<int>& cells) const;

  /// Fixes the candidates of all cells. @param pairs cell and candidate, in the order in which they are to be tried
  void setCandidates(const std::vector<std::pair<int, Index>>& pairs);
  const Index* begin(int cell) const { return candidates_.data() + start_[cell]; }
  const Index* end(int cell) const { return candidates_.data() + start_[cell + 1]; }

 private:
  Vec3 pointAt(int face, double u, double v) const;

  int side_;
  std::vector<Vec3> middles_;
  std::vector<double> radii_;
  std::vector<Index> start_, candidates_;
};

}  // namespace whittle
