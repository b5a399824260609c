#include "geometry/smooth_fans.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/surface.h"
#include "mesh/adjacency.h"
#include "mesh/disjoint_sets.h"

namespace whittle {

namespace {

const double kLeastCosine = std::cos(55 * EIGEN_PI / 180);
/// Faces that are all nearer than this to one direction bend by less than that between any two.
const double kLeastCosineOfMean = std::cos(27.5 * EIGEN_PI / 180);
/// Faces of one edge are held against so many before them: enough for every edge of a surface, and never a square.
constexpr int kMostFacesOfEdge = 8;

/// Vertices whose faces may bend too much, #V. All others have one fan, which is quickly told.
std::vector<bool> mayBend(const Points& normals, const Triangles& triangles, Index vertexCount) {
  Points means = Points::Zero(vertexCount, 3);
  for (Index f = 0; f < triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) means.row(triangles(f, k)) += normals.row(f);
  }
  means.rowwise().normalize();
  std::vector<bool> result(vertexCount, false);
  for (Index f = 0; f < triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const Index v = triangles(f, k);
      if (!(means.row(v).dot(normals.row(f)) >= kLeastCosineOfMean)) result[v] = true;
    }
  }
  return result;
}

/// Tells the fans of one vertex after the other.
class FanFinder {
 public:
  FanFinder(const Points& normals, const Triangles& triangles, Index vertexCount)
      : triangles_(triangles), normals_(normals), place_(vertexCount, -1) {}

  /// Numbers the fans of a vertex by their first faces, from 0; returns how many there are.
  /// @param corners of its faces
  Index find(Index vertex, const Index* corners, Index count) {
    collectSides(vertex, corners, count);
    faces_.reset(count);
    Index joined = 0;
    for (const Side& side : sides_) joined += joinAcross(side, corners);
    for (const Index neighbour : spokes_) place_[neighbour] = -1;
    if (withoutArea_ == 0 && joined >= count - 1) {
      fans_.assign(count, 0);
      return 1;
    }
    return numberFans(corners, count);
  }
  /// Of each corner.
  const std::vector<Index>& fans() const { return fans_; }

 private:
  /// A face at one of its two edges to the vertex.
  struct Side {
    Index face;   // its place among the corners
    Index spoke;  // the edge, by its place in `spokes_`
  };

  bool hasArea(Index corner) const { return !normals_.row(corner / 3).isZero(0); }

  void collectSides(Index vertex, const Index* corners, Index count) {
    sides_.clear(), spokes_.clear();
    withoutArea_ = 0;
    edges_.reset(2 * count);
    for (Index i = 0; i < count; ++i) {
      Index sides[2] = {-1, -1};
      for (int k = 0; k < 2; ++k) {
        const Index neighbour = triangles_(corners[i] / 3, kOtherCorners[corners[i] % 3][k]);
        if (neighbour == vertex) continue;
        if (place_[neighbour] < 0) {
          place_[neighbour] = static_cast<Index>(spokes_.size());
          spokes_.push_back(neighbour);
        }
        sides[k] = place_[neighbour];
        if (hasArea(corners[i])) sides_.push_back({i, sides[k]});
      }
      if (hasArea(corners[i])) continue;
      ++withoutArea_;
      if (sides[0] >= 0 && sides[1] >= 0) edges_.join(sides[0], sides[1]);
    }
    seen_.assign(spokes_.size(), {});
  }

  /// Joins a face to those before it at the same edge that it is smooth with; returns how many sets became one.
  Index joinAcross(const Side& side, const Index* corners) {
    Seen& seen = seen_[edges_.find(side.spoke)];
    Index joined = 0;
    for (int i = 0; i < std::min(seen.count, kMostFacesOfEdge); ++i) {
      const Index other = seen.faces[i];
      const double cosine = normals_.row(corners[side.face] / 3).dot(normals_.row(corners[other] / 3));
      if (cosine >= kLeastCosine) joined += faces_.join(side.face, other);
    }
    seen.faces[seen.count++ % kMostFacesOfEdge] = side.face;
    return joined;
  }

  Index numberFans(const Index* corners, Index count) {
    Index fanCount = 0;
    fans_.assign(count, 0);
    for (Index i = 0; i < count; ++i) {
      if (hasArea(corners[i])) fans_[i] = faces_.find(i) == i ? fanCount++ : fans_[faces_.find(i)];
    }
    return std::max<Index>(fanCount, 1);  // what has no area may be anybody's: the first one's
  }

  /// The last faces at an edge.
  struct Seen {
    int count = 0;
    Index faces[kMostFacesOfEdge];
  };

  const Triangles& triangles_;
  const Points& normals_;
  std::vector<Index> place_;   // #V, of a neighbour in `spokes_`, or −1
  std::vector<Index> spokes_;  // neighbours
  std::vector<Side> sides_;
  std::vector<Seen> seen_;  // of each spoke
  DisjointSets edges_, faces_;
  Index withoutArea_ = 0;
  std::vector<Index> fans_;
};

}  // namespace

SmoothFans smoothFans(const Points& positions, const Triangles& triangles) {
  const Index vertexCount = static_cast<Index>(positions.rows());
  const Points normals = sureNormals(positions, triangles);
  const std::vector<bool> bends = mayBend(normals, triangles, vertexCount);
  SmoothFans result;
  result.start.resize(vertexCount + 1);
  std::iota(result.start.begin(), result.start.end(), 0);
  if (std::find(bends.begin(), bends.end(), true) == bends.end()) return result;

  const Fans stars(triangles, vertexCount);
  FanFinder finder(normals, triangles, vertexCount);
  result.ofCorner.resize(triangles.rows(), 3);
  Index fan = 0;
  for (Index v = 0; v < vertexCount; ++v) {
    const Index first = stars.start[v], count = stars.start[v + 1] - first;
    const Index fanCount = bends[v] ? finder.find(v, stars.corners.data() + first, count) : 1;
    for (Index i = 0; i < count; ++i)
      result.ofCorner.data()[stars.corners[first + i]] = fan + (bends[v] ? finder.fans()[i] : 0);
    fan += fanCount;
    result.start[v + 1] = fan;
  }
  if (result.count() == vertexCount) result.ofCorner.resize(0, 3);
  return result;
}

}  // namespace whittle
