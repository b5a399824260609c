#include "methods/alternating/bevels.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "methods/alternating/flat_regions.h"

namespace whittle {

namespace {

constexpr double kLeastBend = 20 * EIGEN_PI / 180, kMostBend = 70 * EIGEN_PI / 180;
constexpr double kLeastLength = 2, kLeastBeside = 2;  // in widths of the strip
constexpr double kLeastSide = 0.7;                    // of the length, which creases on either side have
constexpr double kAlong = 0.94;                       // cosine to the strip from which on an edge is at its side

/// A side of a flat region: an edge, the face beyond it, and whether that falls away from the region's plane.
struct Side {
  Vec3 middle, vector;
  double bend;
  bool isConvex;
  Index beyond;  // region
};

/// Flat regions of a mesh and their sides.
class RegionSides {
 public:
  RegionSides(const TriangleMesh& mesh, const std::vector<FacePair>& pairs)
      : mesh_(mesh), regions_(mesh.faceCount(), pairs), sides_(regions_.faces.size()) {
    for (const FacePair& pair : pairs) {
      if (regions_.of[faceOf(pair.first)] == regions_.of[faceOf(pair.second)]) continue;
      addSide(pair.first, pair.second, pair.angle);
      addSide(pair.second, pair.first, pair.angle);
    }
  }

  Index count() const { return static_cast<Index>(regions_.faces.size()); }
  const std::vector<Index>& faces(Index region) const { return regions_.faces[region]; }
  const std::vector<Side>& sides(Index region) const { return sides_[region]; }

  Vec3 normal(Index region) const {
    Vec3 sum = Vec3::Zero();
    for (const Index f : regions_.faces[region]) sum += areaVector(f);
    return sum.stableNormalized();
  }

  /// Least and largest coordinate along a direction.
  std::array<double, 2> extent(Index region, const Vec3& along) const {
    std::array<double, 2> ends = {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const Index f : regions_.faces[region]) {
      for (int k = 0; k < 3; ++k) {
        const double x = at(3 * f + k).dot(along);
        ends = {std::min(ends[0], x), std::max(ends[1], x)};
      }
    }
    return ends;
  }

 private:
  void addSide(Index own, Index other, double angle) {
    const Vec3 from = at(own), to = at(next(own)), tip = at(next(next(other)));
    const bool isConvex = (tip - from).dot(areaVector(faceOf(own))) < 0;
    sides_[regions_.of[faceOf(own)]].push_back(
        {(from + to) / 2, to - from, angle, isConvex, regions_.of[faceOf(other)]});
  }

  static Index next(Index corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
  Vec3 at(Index corner) const { return mesh_.positions.row(mesh_.triangles(corner / 3, corner % 3)).transpose(); }
  Vec3 areaVector(Index f) const { return (at(3 * f + 1) - at(3 * f)).cross(at(3 * f + 2) - at(3 * f)); }

  const TriangleMesh& mesh_;
  FlatRegions regions_;
  std::vector<std::vector<Side>> sides_;  // by region
};

/// The direction that the sides of a region have most of.
Vec3 directionOf(const std::vector<Side>& sides) {
  Mat3 sum = Mat3::Zero();
  for (const Side& side : sides) sum += side.vector * side.vector.transpose() / side.vector.norm();
  return Eigen::SelfAdjointEigenSolver<Mat3>(sum).eigenvectors().col(2);
}

/// Whether a strip lies between creases as a bevel does.
bool isBetweenCreases(const RegionSides& regions, Index region, const Vec3& along, const Vec3& across) {
  const auto [low, high] = regions.extent(region, across);
  const auto [begin, end] = regions.extent(region, along);
  std::array<double, 2> lengths = {0, 0};
  std::array<int, 2> bends = {0, 0};  // concave, convex
  Index checked = -1;                 // region beside it, the last that was wide enough
  for (const Side& side : regions.sides(region)) {
    const double length = side.vector.norm();
    if (std::abs(side.vector.dot(along)) < kAlong * length) continue;
    if (side.bend < kLeastBend || side.bend > kMostBend) return false;
    if (side.beyond != checked) {
      const Vec3 beside = regions.normal(side.beyond).cross(along).stableNormalized();
      const auto [from, to] = regions.extent(side.beyond, beside);
      if (to - from < kLeastBeside * (high - low)) return false;
      checked = side.beyond;
    }
    lengths[side.middle.dot(across) > (low + high) / 2] += length;
    ++bends[side.isConvex];
  }
  const double least = kLeastSide * (end - begin);
  return lengths[0] >= least && lengths[1] >= least && (bends[0] == 0 || bends[1] == 0);
}

}  // namespace

std::vector<CylinderPatch> bevels(const TriangleMesh& mesh, const std::vector<FacePair>& pairs) {
  std::vector<CylinderPatch> found;
  const RegionSides regions(mesh, pairs);
  for (Index region = 0; region < regions.count(); ++region) {
    if (regions.sides(region).size() < 2) continue;
    const Vec3 along = directionOf(regions.sides(region)), normal = regions.normal(region);
    const Vec3 across = along.cross(normal).stableNormalized();
    const auto [begin, end] = regions.extent(region, along);
    const auto [low, high] = regions.extent(region, across);
    if (!(end - begin >= kLeastLength * (high - low))) continue;
    if (!isBetweenCreases(regions, region, along, across)) continue;
    const Vec3 middle =
        (begin + end) / 2 * along + (low + high) / 2 * across + regions.extent(region, normal)[0] * normal;
    found.push_back({regions.faces(region), along, middle, high - low});
  }
  return found;
}

}  // namespace whittle
