#include "remeshing/remeshed_surface.h"

#include <algorithm>
#include <cmath>

namespace whittle {

namespace {

/// Edges grow by no more than this over their own length, from one to the next.
constexpr double kGrading = 0.25;
/// Edges longer than this times their target are cut.
constexpr double kLong = 4.0 / 3;
/// What a part of a face may turn when it is cut at most, as a cosine.
constexpr double kCutTurn = 0.5;
/// What a face may turn when a vertex moves, as a cosine: 40°.
constexpr double kMoveTurn = 0.77;
/// A face whose thickness is above this may become somewhat thinner by a move.
constexpr double kGoodThickness = 0.35;

}  // namespace

RemeshedSurface::RemeshedSurface(const TriangleMesh& shape, const MeshEdges& edges, const PatchSurface& patches,
                                 const CreaseLines& lines, double tolerance)
    : patches_(patches), lines_(lines), tolerance_(tolerance), mesh_(shape), lineOf_(lines.ofVertices()),
      along_(lines.along()), wanted_(shape.vertexCount(), 0), feet_(shape.vertexCount(), -1) {
  for (Index e = 0; e < edges.count(); ++e) {
    if (lines.ofEdges()[e] >= 0) mesh_.setLine(edges.ends[e][0], edges.ends[e][1], lines.ofEdges()[e]);
  }
  for (Index f = 0; f < shape.faceCount(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const Index v = shape.triangles(f, k);
      wanted_[v] = feet_[v] < 0 ? patches.sizeAt(f) : std::min(wanted_[v], patches.sizeAt(f));
      feet_[v] = f;
    }
  }
  sizes_ = wanted_;
}

void RemeshedSurface::grade(Index vertex) {
  mesh_.forEachCorner(vertex, [&](Index corner) {
    for (const Index other : {mesh_.head(corner), mesh_.opposite(corner)}) {
      sizes_[vertex] = std::min(sizes_[vertex], sizes_[other] + kGrading * edgeLength(vertex, other));
    }
  });
}

bool RemeshedSurface::split(Index face, double scale) {
  Index longest = -1;
  double most = kLong * scale;
  for (Index h = 3 * face; h < 3 * face + 3; ++h) {
    const Index a = mesh_.tail(h), b = mesh_.head(h);
    const double length = edgeLength(a, b) / target(a, b);
    if (length <= most) continue;
    most = length;
    longest = h;
  }
  if (longest >= 0) splitEdge(longest);
  return longest >= 0;
}

bool RemeshedSurface::splitsWell(Index a, Index b, const Vec3& place) const {
  bool isGood = true;
  mesh_.forEachAlong(a, b, [&](Index h) {
    const Vec3 whole = mesh_.areaNormal(faceOf(h));
    for (const Index end : {a, b}) {
      const Vec3 part = mesh_.areaNormal(faceOf(h), end, place);
      isGood = isGood && part.dot(whole) > kCutTurn * part.norm() * whole.norm();
    }
  });
  return isGood;
}

Vec3 RemeshedSurface::middle(Index halfEdge, Index& foot) const {
  const Index a = mesh_.tail(halfEdge), b = mesh_.head(halfEdge), line = mesh_.line(halfEdge);
  const Vec3 half = (mesh_.position(a) + mesh_.position(b)) / 2;
  if (line >= 0) {
    const Vec3 place = lines_.at(line, (placeOn(line, a) + placeOn(line, b)) / 2);
    return splitsWell(a, b, place) ? place : half;
  }
  Vec3 normal = Vec3::Zero();
  mesh_.forEachAlong(a, b, [&](Index h) { normal += mesh_.areaNormal(faceOf(h)); });
  const PatchSurface::Foot found = patches_.project(half, normal, mesh_.origin(faceOf(halfEdge)));
  foot = found.face;
  return splitsWell(a, b, found.point) ? found.point : half;
}

void RemeshedSurface::splitEdge(Index halfEdge) {
  const Index a = mesh_.tail(halfEdge), b = mesh_.head(halfEdge), line = mesh_.line(halfEdge);
  Index foot = mesh_.origin(faceOf(halfEdge));
  const Vec3 place = middle(halfEdge, foot);
  lineOf_.push_back(line >= 0 ? line : CreaseLines::kNone);
  along_.push_back(line >= 0 ? (placeOn(line, a) + placeOn(line, b)) / 2 : 0);
  wanted_.push_back(line >= 0 ? std::min(std::max(wanted_[a], wanted_[b]), patches_.sizeAt(foot))
                              : patches_.sizeAt(foot));
  sizes_.push_back(std::min(wanted_.back(), (sizes_[a] + sizes_[b]) / 2));
  feet_.push_back(foot);
  mesh_.splitEdge(a, b, mesh_.addVertex(place));
}

std::array<Index, 2> RemeshedSurface::lineNeighbours(Index v) const {
  std::array<Index, 2> found = {-1, -1};
  const auto see = [&](Index other) {
    if (found[0] < 0 || found[0] == other) {
      found[0] = other;
    } else {
      found[1] = other;
    }
  };
  mesh_.forEachCorner(v, [&](Index corner) {
    if (mesh_.line(corner) >= 0) see(mesh_.head(corner));
    const Index in = EditableMesh::previousInFace(corner);
    if (mesh_.line(in) >= 0) see(mesh_.tail(in));
  });
  return found;
}

bool RemeshedSurface::movesWell(Index v, const Vec3& place) const {
  bool isGood = true;
  double before = 1, after = 1;
  mesh_.forEachCorner(v, [&](Index corner) {
    if (!isGood) return;
    const Index face = faceOf(corner);
    const Vec3 &b = mesh_.position(mesh_.head(corner)), &c = mesh_.position(mesh_.opposite(corner)),
               &at = mesh_.position(v);
    const Vec3 old = mesh_.areaNormal(face), turned = mesh_.areaNormal(face, v, place);
    const double far = (c - b).squaredNorm();
    before = std::min(before, old.norm() / std::max({far, (b - at).squaredNorm(), (c - at).squaredNorm()}));
    after = std::min(after, turned.norm() / std::max({far, (b - place).squaredNorm(), (c - place).squaredNorm()}));
    isGood = turned.dot(old) > kMoveTurn * turned.norm() * old.norm();
  });
  return isGood && (after >= before || after > kGoodThickness);
}

void RemeshedSurface::smooth(Index v) {
  if (!mesh_.isUsed(v) || lineOf_[v] == CreaseLines::kCorner) return;
  if (isFree(v)) {
    smoothOnPatch(v);
  } else {
    smoothOnLine(v);
  }
}

void RemeshedSurface::smoothOnLine(Index v) {
  const Index line = lineOf_[v];
  const auto [a, b] = lineNeighbours(v);
  if (a < 0 || b < 0) return;
  const double from = placeOn(line, a), to = placeOn(line, b);
  const double here = along_[v], place = (from * sizes_[b] + to * sizes_[a]) / (sizes_[a] + sizes_[b]);
  const auto off = [&](double at) {
    return std::max(lines_.deviation(line, from, at), lines_.deviation(line, at, to));
  };
  const double allowed = std::max(tolerance_, off(here));
  for (const double at : {place, (place + here) / 2}) {
    const Vec3 moved = lines_.at(line, at);
    if (off(at) > allowed || !movesWell(v, moved)) continue;
    along_[v] = at;
    mesh_.move(v, moved);
    return;
  }
}

void RemeshedSurface::smoothOnPatch(Index v) {
  Vec3 normal = Vec3::Zero(), sum = Vec3::Zero();
  double weights = 0;
  mesh_.forEachCorner(v, [&](Index corner) {
    const Index b = mesh_.head(corner), c = mesh_.opposite(corner);
    const Vec3 area = mesh_.areaNormal(faceOf(corner));
    const double size = sizes_[v] + sizes_[b] + sizes_[c], weight = area.norm() / (size * size);
    normal += area;
    sum += weight * (mesh_.position(v) + mesh_.position(b) + mesh_.position(c)) / 3;
    weights += weight;
  });
  if (weights <= 0 || normal.squaredNorm() <= 0) return;
  normal.normalize();
  const Vec3 here = mesh_.position(v);
  Vec3 step = sum / weights - here;
  step -= normal.dot(step) * normal;
  for (const double share : {1.0, 0.4}) {
    const PatchSurface::Foot foot = patches_.project(here + share * step, normal, feet_[v]);
    if (!movesWell(v, foot.point)) continue;
    mesh_.move(v, foot.point);
    feet_[v] = foot.face;
    wanted_[v] = patches_.sizeAt(foot.face);
    return;
  }
}

}  // namespace whittle
