#pragma once

#include <array>
#include <vector>

#include "base/status.h"
#include "base/types.h"

namespace whittle {

/// Holds row x of a matrix (#n×3) on the plane normal·x = offset. A single coordinate is held by a plane whose normal
/// is that axis, a line by two planes, a point by three.
struct RowPlane {
  Index row;
  Vec3 normal;  // of any length but zero
  double offset;
};

/// A row that is held on planes, in coordinates of its own: orthonormal axes, of which the first `freedom` (0 to 2) lie
/// in all of its planes. The coordinates along the others are held.
struct HeldRow {
  Index row;
  int freedom;
  std::array<Vec3, 3> axes;
  std::array<double, 3> held;  // coordinates along the axes, of the held ones

  /// Moves a point to where it is held, the shortest way. One that is there but for rounding keeps its very bits.
  void satisfy(Eigen::Ref<Vec3> x) const;
};

/// Joins the planes of every row, rows ascending. Rows that have the same planes have the same axes, and planes across
/// an axis of space leave those of the others. Sizes are taken to be about 1: planes that are the same one may have
/// offsets that differ by 1e-9.
/// @param sameNormal sine of the angle to the others below which a plane holds nothing that they do not hold
/// @returns `badPlanes` with the row as its element if two of its planes exclude each other or a normal has no
///   direction
Status joinPlanes(std::vector<RowPlane> planes, std::vector<HeldRow>& rows, double sameNormal = 1e-8);

/// Moves rows of X (#n×3) onto their planes, to double precision.
void satisfyPlanes(const std::vector<HeldRow>& rows, Points& X);

}  // namespace whittle
