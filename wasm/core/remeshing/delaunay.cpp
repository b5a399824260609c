#include "remeshing/delaunay.h"

#include <algorithm>
#include <utility>

namespace whittle {

namespace {

/// A cube cut in six along its diagonal, by the corners' numbers.
constexpr Index kCube[6][4] = {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};

/// Sides of a tetrahedron are its other three points.
bool hasSide(const DelaunayTetrahedra::Tetrahedron& tetrahedron, int side,
             const DelaunayTetrahedra::Tetrahedron& other) {
  for (int k = 0; k < 4; ++k) {
    const bool isShared = std::count(other.points.begin(), other.points.end(), tetrahedron.points[k]) > 0;
    if (k != side && !isShared) return false;
  }
  return true;
}

}  // namespace

DelaunayTetrahedra::DelaunayTetrahedra(const LatticePoint& low, const LatticePoint& high) {
  for (int corner = 0; corner < 8; ++corner) {
    points_.push_back({corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y, corner & 4 ? high.z : low.z});
  }
  for (const auto& four : kCube) {
    Tetrahedron tetrahedron{{four[0], four[1], four[2], four[3]}, {-1, -1, -1, -1}};
    const auto& p = tetrahedron.points;
    if (orientation(points_[p[0]], points_[p[1]], points_[p[2]], points_[p[3]]) < 0) {
      std::swap(tetrahedron.points[0], tetrahedron.points[1]);
    }
    tetrahedra_[claim()] = tetrahedron;
  }
  joinNeighbours();
}

void DelaunayTetrahedra::joinNeighbours() {
  const Index count = static_cast<Index>(tetrahedra_.size());
  for (Index t = 0; t < count; ++t) {
    for (int side = 0; side < 4; ++side) {
      for (Index other = 0; other < count; ++other) {
        if (other != t && hasSide(tetrahedra_[t], side, tetrahedra_[other])) tetrahedra_[t].neighbours[side] = other;
      }
    }
  }
}

void DelaunayTetrahedra::reserve(Index pointCount) {
  const std::size_t tetrahedra = std::size_t{7} * pointCount;
  points_.reserve(pointCount);
  tetrahedra_.reserve(tetrahedra);
  filled_.reserve(tetrahedra);
  seen_.reserve(tetrahedra);
}

Index DelaunayTetrahedra::add(const LatticePoint& point) {
  const Index number = pointCount();
  const Index first = locate(point);
  points_.push_back(point);
  findCavity(first, point);
  fillCavity(number);
  return number;
}

/// Walks from tetrahedron to tetrahedron, always through a side beyond which the point lies. Sides are tried from
/// another one each time: among tetrahedra of one sphere a stubborn walk may go round for ever.
Index DelaunayTetrahedra::locate(const LatticePoint& point) {
  Index present = last_, before = -1;
  for (bool isThere = false; !isThere;) {
    isThere = true;
    turn_ ^= turn_ << 13, turn_ ^= turn_ >> 17, turn_ ^= turn_ << 5;
    for (int k = 0; k < 4; ++k) {
      const int side = static_cast<int>((turn_ + static_cast<std::uint32_t>(k)) & 3);
      const Index next = tetrahedra_[present].neighbours[side];
      if (next < 0 || next == before || !isBeyond(point, tetrahedra_[present], side)) continue;
      before = std::exchange(present, next);
      isThere = false;
      break;
    }
  }
  return present;
}

bool DelaunayTetrahedra::isBeyond(const LatticePoint& point, const Tetrahedron& tetrahedron, int side) const {
  const LatticePoint* corners[4];
  for (int k = 0; k < 4; ++k) corners[k] = k == side ? &point : &points_[tetrahedron.points[k]];
  return orientation(*corners[0], *corners[1], *corners[2], *corners[3]) < 0;
}

/// Finds the tetrahedra whose spheres hold a point, from the one that holds it: they hang together, and the point sees
/// all their outer faces from within, as ties count as outside.
void DelaunayTetrahedra::findCavity(Index first, const LatticePoint& point) {
  const Index stays = 2 * (pointCount() - 1), goes = stays + 1;
  cavity_.assign(1, first);
  faces_.clear();
  seen_[first] = goes;
  for (std::size_t i = 0; i < cavity_.size(); ++i) {
    const Index present = cavity_[i];
    for (int side = 0; side < 4; ++side) {
      const Index next = tetrahedra_[present].neighbours[side];
      if (next >= 0 && seen_[next] != goes && seen_[next] != stays) {
        const auto& p = tetrahedra_[next].points;
        const bool isHit = isInSphere(points_[p[0]], points_[p[1]], points_[p[2]], points_[p[3]], point);
        seen_[next] = isHit ? goes : stays;
        if (isHit) cavity_.push_back(next);
      }
      if (next < 0 || seen_[next] == stays) faces_.push_back({present, side});
    }
  }
}

Index DelaunayTetrahedra::claim() {
  ++made_;
  if (free_.empty()) {
    tetrahedra_.emplace_back();
    filled_.emplace_back();
    seen_.push_back(-1);
    return static_cast<Index>(tetrahedra_.size()) - 1;
  }
  const Index place = free_.back();
  free_.pop_back();
  return place;
}

/// Puts a tetrahedron between the point and each face of the cavity.
void DelaunayTetrahedra::fillCavity(Index point) {
  for (const Face& face : faces_) {
    const Index created = claim();
    filled_[face.tetrahedron][face.side] = created;
    Tetrahedron& tetrahedron = tetrahedra_[created];
    tetrahedron.points = tetrahedra_[face.tetrahedron].points;
    tetrahedron.points[face.side] = point;
    const Index outside = tetrahedra_[face.tetrahedron].neighbours[face.side];
    tetrahedron.neighbours[face.side] = outside;
    if (outside >= 0) tetrahedra_[outside].neighbours[sideTo(outside, face.tetrahedron)] = created;
    seen_[created] = -1;
    last_ = created;
  }
  for (const Face& face : faces_) {
    const Index created = filled_[face.tetrahedron][face.side];
    for (int k = 0; k < 4; ++k) {
      if (k != face.side) tetrahedra_[created].neighbours[k] = acrossCavity(face, k);
    }
  }
  for (const Index gone : cavity_) tetrahedra_[gone].points[0] = -1;
  free_.insert(free_.end(), cavity_.begin(), cavity_.end());
}

/// The new tetrahedron on the face of the cavity that meets this one in the edge opposite to `pivot`: the way there
/// turns around that edge, through the tetrahedra that go.
Index DelaunayTetrahedra::acrossCavity(Face face, int pivot) const {
  const Index goes = seen_[face.tetrahedron];
  Index present = face.tetrahedron;
  int from = face.side, through = pivot;
  for (;;) {
    const Tetrahedron& tetrahedron = tetrahedra_[present];
    const Index next = tetrahedron.neighbours[through];
    if (next < 0 || seen_[next] != goes) return filled_[present][through];
    const auto& points = tetrahedra_[next].points;
    const Index left = tetrahedron.points[from];  // lies on the face between the two, and is left behind by the turn
    from = sideTo(next, present);
    through = static_cast<int>(std::find(points.begin(), points.end(), left) - points.begin());
    present = next;
  }
}

int DelaunayTetrahedra::sideTo(Index tetrahedron, Index neighbour) const {
  const auto& neighbours = tetrahedra_[tetrahedron].neighbours;
  return static_cast<int>(std::find(neighbours.begin(), neighbours.end(), neighbour) - neighbours.begin());
}

}  // namespace whittle
