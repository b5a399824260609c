#include "targets/direction_grid.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace whittle {

namespace {

/// Faces 0, 1: +x, −x; 2, 3: ±y; 4, 5: ±z.
int faceOf(const Vec3& n) {
  int axis;
  n.cwiseAbs().maxCoeff(&axis);
  return 2 * axis + (n[axis] < 0);
}

/// Height over a face's plane through the centre; places in it are coordinates over height.
double heightOver(int face, const Vec3& n) { return face % 2 ? -n[face / 2] : n[face / 2]; }

double angleBetween(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

/// Below this height a projection reaches so far that the whole face is taken instead.
constexpr double kFlat = 0.2;
const double kFaceRadius = std::acos(1 / std::sqrt(3.0));
/// How far rounding may push a place over the edge of its cell.
constexpr double kRounding = 1e-9;

}  // namespace

DirectionGrid::DirectionGrid(int side)
    : side_(side), middles_(cellCount()), radii_(cellCount()), start_(cellCount() + 1, 0) {
  for (int cell = 0; cell < cellCount(); ++cell) {
    const int face = cell / (side_ * side_), row = cell / side_ % side_, column = cell % side_;
    middles_[cell] = pointAt(face, column + 0.5, row + 0.5);
    radii_[cell] = 0;
    for (int corner = 0; corner < 4; ++corner) {
      const Vec3 at = pointAt(face, column + corner % 2, row + corner / 2);
      radii_[cell] = std::max(radii_[cell], angleBetween(middles_[cell], at));
    }
  }
}

Vec3 DirectionGrid::pointAt(int face, double u, double v) const {
  Vec3 n;
  n[face / 2] = face % 2 ? -1 : 1;
  n[(face / 2 + 1) % 3] = 2 * u / side_ - 1;
  n[(face / 2 + 2) % 3] = 2 * v / side_ - 1;
  return n.normalized();
}

int DirectionGrid::cellOf(const Vec3& n) const {
  const int face = faceOf(n), axis = face / 2;
  const double scale = 0.5 * side_ / heightOver(face, n);
  const auto place = [&](double coordinate) {
    return std::clamp(static_cast<int>(scale * coordinate + 0.5 * side_), 0, side_ - 1);
  };
  return (face * side_ + place(n[(axis + 2) % 3])) * side_ + place(n[(axis + 1) % 3]);
}

void DirectionGrid::cellsOf(const Mat3& corners, std::vector<int>& cells) const {
  const Vec3 center = corners.rowwise().sum().normalized();
  double radius = 0;
  for (int k = 0; k < 3; ++k) radius = std::max(radius, angleBetween(center, corners.col(k)));
  for (int face = 0; face < 6; ++face) {
    const int axis = face / 2;
    const Vec3 pole = (face % 2 ? -1.0 : 1.0) * Vec3::Unit(axis);
    if (angleBetween(center, pole) - radius > kFaceRadius + kRounding) continue;
    int low[2] = {0, 0}, high[2] = {side_ - 1, side_ - 1};
    double heights[3];
    for (int k = 0; k < 3; ++k) heights[k] = heightOver(face, corners.col(k));
    if (*std::min_element(heights, heights + 3) > kFlat) {
      for (int d = 0; d < 2; ++d) {
        double least = INFINITY, most = -INFINITY;
        for (int k = 0; k < 3; ++k) {
          const double place = 0.5 * side_ * (corners((axis + 1 + d) % 3, k) / heights[k] + 1);
          least = std::min(least, place), most = std::max(most, place);
        }
        low[d] = std::max(0, static_cast<int>(std::floor(least - kRounding)));
        high[d] = std::min(side_ - 1, static_cast<int>(std::floor(most + kRounding)));
      }
    }
    for (int row = low[1]; row <= high[1]; ++row) {
      for (int column = low[0]; column <= high[0]; ++column) {
        const int cell = (face * side_ + row) * side_ + column;
        if (angleBetween(center, middles_[cell]) <= radius + radii_[cell] + kRounding) cells.push_back(cell);
      }
    }
  }
}

void DirectionGrid::setCandidates(const std::vector<std::pair<int, Index>>& pairs) {
  std::fill(start_.begin(), start_.end(), 0);
  for (const auto& pair : pairs) ++start_[pair.first + 1];
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  candidates_.resize(pairs.size());
  std::vector<Index> next(start_.begin(), start_.end() - 1);
  for (const auto& [cell, candidate] : pairs) candidates_[next[cell]++] = candidate;
}

}  // namespace whittle
