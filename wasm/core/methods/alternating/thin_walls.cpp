#include "methods/alternating/thin_walls.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/surface.h"
#include "geometry/triangle_contact.h"
#include "methods/alternating/flat_regions.h"

namespace whittle {

namespace {

const double kFacing = -std::cos(3 * EIGEN_PI / 180);
/// Distance of two sides over the smaller of their extents, below which they are a wall.
constexpr double kThin = 0.5;
/// The thickest wall, of the mesh's longest side.
constexpr double kThickest = 0.25;
/// Of a tie, against the 1 / l̄² that an edge of mean length has.
constexpr double kStiffness = 300;
constexpr Index kSliceOfFaces = 1500;
/// What is thicker, as a share of the longest side, or does not look the other way, is no wall to a probe.
constexpr double kProbed = 0.12, kLookingAway = -0.985;
constexpr Index kMostProbes = 3000;

}  // namespace

ThinWallSearch::ThinWallSearch(const RestSurface& surface) : surface_(surface) {
  joinSides();
  std::vector<Box> boxes;
  boxes.reserve(surface.faceCount());
  for (Index f = 0; f < surface.faceCount(); ++f) {
    Box box;
    for (int k = 0; k < 3; ++k) box.extend(Vec3(surface.mesh.positions.row(surface.mesh.triangles(f, k)).transpose()));
    boxes.push_back(box);
  }
  tree_ = std::make_unique<BoxTree>(std::move(boxes));
}

void ThinWallSearch::joinSides() {
  FlatRegions regions(surface_.faceCount(), surface_.pairs);
  const Scalars areas = faceAreas(surface_.mesh.positions, surface_.mesh.triangles);
  for (const std::vector<Index>& faces : regions.faces) {
    double area = 0;
    for (const Index f : faces) area += areas[f];
    extents_.push_back(std::sqrt(area));
  }
  wallsOfSide_.resize(regions.faces.size());
  result_.sideOf = std::move(regions.of);
}

double ThinWallSearch::next() {
  constexpr double kTree = 0.2;  // share of the work
  if (!isTreeGrown_) {
    isTreeGrown_ = tree_->buildNext(50000);
    return isTreeGrown_ ? kTree : kTree / 2;
  }
  const Index end = std::min(next_ + kSliceOfFaces, surface_.faceCount());
  const Index stride = 1 + surface_.faceCount() / kMostProbes;
  for (; next_ < end; ++next_) {
    tie(next_);
    if (next_ % stride == 0) probe(next_);
  }
  return next_ == surface_.faceCount() ? 1 : kTree + (1 - kTree) * next_ / surface_.faceCount();
}

ThinWallSearch::Behind ThinWallSearch::lookThrough(Index face, double reach) const {
  const Triangles& triangles = surface_.mesh.triangles;
  const auto corner = [&](Index f, int k) -> Vec3 { return surface_.mesh.positions.row(triangles(f, k)).transpose(); };
  const Vec3 from = (corner(face, 0) + corner(face, 1) + corner(face, 2)) / 3;
  const Vec3 to = from - reach * surface_.faceNormals.row(face).transpose();
  Behind first{-1, std::numeric_limits<double>::infinity(), Vec3::Zero()};
  tree_->findIn(Box(from.cwiseMin(to), from.cwiseMax(to)), [&](Index f) {
    if (f == face) return false;
    const auto met = crossing(from, to, corner(f, 0), corner(f, 1), corner(f, 2));
    if (met && met->along * reach < first.distance) first = {f, met->along * reach, met->weights};
    return false;
  });
  return first;
}

void ThinWallSearch::tie(Index face) {
  const Index side = result_.sideOf[face];
  const Behind first = lookThrough(face, std::min(kThickest, kThin * extents_[side]));
  if (first.face < 0 || surface_.faceNormals.row(first.face).dot(surface_.faceNormals.row(face)) > kFacing) return;
  const Index behind = result_.sideOf[first.face];
  if (behind == side || first.distance > kThin * extents_[behind]) return;
  const Vec3 n = surface_.faceNormals.row(face).transpose();
  result_.ties.push_back({wallOf(side, behind, n), face, first.face, first.weights});
}

void ThinWallSearch::probe(Index face) {
  const Behind first = lookThrough(face, kProbed);
  if (first.face < 0 || surface_.faceNormals.row(first.face).dot(surface_.faceNormals.row(face)) > kLookingAway) return;
  result_.probes.push_back({face, first.face, first.weights});
}

Index ThinWallSearch::wallOf(Index side, Index behind, const Vec3& normal) {
  for (const Index wall : wallsOfSide_[side]) {
    const ThinWall& known = result_.walls[wall];
    if (known.sides[0] == behind || known.sides[1] == behind) return wall;
  }
  const Index wall = static_cast<Index>(result_.walls.size());
  result_.walls.push_back({{side, behind}, normal});
  wallsOfSide_[side].push_back(wall);
  wallsOfSide_[behind].push_back(wall);
  return wall;
}

std::vector<bool> keptWalls(const ThinWalls& walls, const RestSurface& surface, const std::vector<PointRow>& handles) {
  std::vector<Index> handleOf(surface.vertexCount(), -1);
  for (std::size_t h = 0; h < handles.size(); ++h) {
    for (int i = 0; i < handles[h].count; ++i) handleOf[handles[h].vertices[i]] = static_cast<Index>(h);
  }
  std::vector<std::vector<Index>> handlesOfSide(surface.faceCount());
  for (Index f = 0; f < surface.faceCount(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const Index h = handleOf[surface.mesh.triangles(f, k)];
      if (h >= 0) handlesOfSide[walls.sideOf[f]].push_back(h);
    }
  }
  std::vector<bool> kept;
  for (const ThinWall& wall : walls.walls) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Index side : wall.sides) {
      for (const Index h : handlesOfSide[side]) {
        const double move = -handles[h].residual(surface.mesh.positions).dot(wall.normal);
        low = std::min(low, move);
        high = std::max(high, move);
      }
    }
    kept.push_back(!(high - low > kMovedApart));
  }
  return kept;
}

void addWallRows(const ThinWalls& walls, const std::vector<bool>& kept, const RestSurface& surface,
                 std::vector<PointRow>& rows) {
  const Triangles& triangles = surface.mesh.triangles;
  for (const WallTie& tie : walls.ties) {
    if (!kept[tie.wall]) continue;
    PointRow row;
    row.stiffness = kStiffness;
    for (int k = 0; k < 3; ++k) {
      row.add(triangles(tie.face, k), 1.0 / 3);
      row.add(triangles(tie.behind, k), -tie.weights[k]);
    }
    row.counts = PointRow::Counts::along;
    row.direction = surface.faceNormals.row(tie.face).transpose();
    row.target = row.residual(surface.mesh.positions);
    rows.push_back(row);
  }
}

}  // namespace whittle
