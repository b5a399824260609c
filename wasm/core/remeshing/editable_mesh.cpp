#include "remeshing/editable_mesh.h"

#include <algorithm>
#include <numeric>

namespace whittle {

EditableMesh::EditableMesh(const TriangleMesh& mesh)
    : positions_(mesh.vertexCount()), origins_(mesh.vertexCount()), wasUsed_(mesh.vertexCount(), false),
      first_(mesh.vertexCount(), -1), counts_(mesh.vertexCount(), 0), stamps_(mesh.vertexCount(), 0) {
  std::iota(origins_.begin(), origins_.end(), 0);
  for (Index v = 0; v < mesh.vertexCount(); ++v) positions_[v] = mesh.positions.row(v).transpose();
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    addFace(mesh.triangles(f, 0), mesh.triangles(f, 1), mesh.triangles(f, 2), f);
    for (int k = 0; k < 3; ++k) wasUsed_[mesh.triangles(f, k)] = true;
  }
}

void EditableMesh::move(Index v, const Vec3& position) {
  if (position == positions_[v]) return;
  positions_[v] = position;
  origins_[v] = -1;
}

void EditableMesh::setLine(Index a, Index b, Index line) {
  forEachAlong(a, b, [&](Index h) { lines_[h] = line; });
}

Index EditableMesh::faceCountAlong(Index a, Index b) const {
  Index count = 0;
  forEachAlong(a, b, [&](Index) { ++count; });
  return count;
}

Index EditableMesh::twin(Index halfEdge) const {
  Index found = -1, count = 0;
  forEachAlong(tail(halfEdge), head(halfEdge), [&](Index h) {
    ++count;
    if (h != halfEdge) found = h;
  });
  return count == 2 ? found : -1;
}

bool EditableMesh::hasFace(Index a, Index b, Index c) const {
  bool isThere = false;
  forEachAlong(a, b, [&](Index h) { isThere = isThere || opposite(h) == c; });
  return isThere;
}

Vec3 EditableMesh::areaNormal(Index face) const {
  const Vec3 &a = positions_[corners_[3 * face]], &b = positions_[corners_[3 * face + 1]],
             &c = positions_[corners_[3 * face + 2]];
  return (b - a).cross(c - a);
}

Vec3 EditableMesh::areaNormal(Index face, Index v, const Vec3& elsewhere) const {
  const Vec3* at[3];
  for (int k = 0; k < 3; ++k) {
    const Index corner = corners_[3 * face + k];
    at[k] = corner == v ? &elsewhere : &positions_[corner];
  }
  return (*at[1] - *at[0]).cross(*at[2] - *at[0]);
}

Index EditableMesh::addVertex(const Vec3& position) {
  positions_.push_back(position);
  origins_.push_back(-1);
  first_.push_back(-1);
  counts_.push_back(0);
  stamps_.push_back(0);
  return vertexCount() - 1;
}

void EditableMesh::splitEdge(Index a, Index b, Index v) {
  forEachAlong(a, b, [&](Index h) {
    const Index face = faceOf(h), next = nextInFace(h), to = corners_[next], side = corners_[previousInFace(h)];
    const Index beyond = addFace(v, to, side, faceOrigins_[face]);
    lines_[3 * beyond] = lines_[h];
    lines_[3 * beyond + 1] = lines_[next];
    setCorner(next, v);
    lines_[next] = -1;
  });
}

bool EditableMesh::canCollapse(Index a, Index b) {
  const Index seen = ++stamp_, counted = ++stamp_;
  const auto others = [&](Index corner) {
    return std::array{corners_[nextInFace(corner)], corners_[previousInFace(corner)]};
  };
  Index sides = 0, common = 0;
  forEachAlong(a, b, [&](Index) { ++sides; });
  forEachCorner(a, [&](Index corner) {
    for (const Index v : others(corner)) stamps_[v] = seen;
  });
  bool isFree = true;
  forEachCorner(b, [&](Index corner) {
    const auto [v, w] = others(corner);
    if (v != a && w != a && stamps_[v] >= seen && stamps_[w] >= seen) isFree = false;  // that face may be there already
    for (const Index other : {v, w}) {
      if (other == a || stamps_[other] != seen) continue;
      stamps_[other] = counted;
      ++common;
    }
  });
  return isFree && common == sides;
}

void EditableMesh::collapse(Index a, Index b) {
  forEachCorner(b, [&](Index corner) {
    const Index next = nextInFace(corner), previous = previousInFace(corner);
    if (corners_[next] != a && corners_[previous] != a) return setCorner(corner, a);
    // The two sides of the face beside the edge become one.
    const bool isOut = corners_[next] == a;
    const Index side = corners_[isOut ? previous : next], line = lines_[next];
    const Index own = lines_[isOut ? previous : corner];
    removeFace(faceOf(corner));
    const Index kept = std::max(line, own);
    if (kept < 0) return;
    setLine(a, side, kept);
    setLine(b, side, kept);
  });
}

bool EditableMesh::canFlip(Index halfEdge) const {
  const Index other = lines_[halfEdge] < 0 ? twin(halfEdge) : -1;
  if (other < 0 || tail(other) == tail(halfEdge)) return false;
  const Index c = opposite(halfEdge), d = opposite(other);
  return c != d && faceCountAlong(c, d) == 0;
}

void EditableMesh::flip(Index halfEdge) {
  // From (a, b, c) and (b, a, d) to (d, b, c) and (c, a, d).
  const Index other = twin(halfEdge), c = opposite(halfEdge), d = opposite(other);
  const Index previous = previousInFace(halfEdge), previousOther = previousInFace(other);
  const Index sideC = lines_[previous], sideD = lines_[previousOther];
  setCorner(halfEdge, d);
  setCorner(other, c);
  lines_[halfEdge] = sideD;                       // d → b
  lines_[other] = sideC;                          // c → a
  lines_[previous] = lines_[previousOther] = -1;  // the new edge; b → c and a → d are what they were
}

void EditableMesh::removeFace(Index face) {
  for (Index corner = 3 * face; corner < 3 * face + 3; ++corner) {
    unhang(corner);
    corners_[corner] = -1;
  }
}

Index EditableMesh::addFace(Index a, Index b, Index c, Index origin) {
  const Index face = faceCount();
  faceOrigins_.push_back(origin);
  for (const Index v : {a, b, c}) {
    corners_.push_back(-1);
    next_.push_back(-1);
    previous_.push_back(-1);
    lines_.push_back(-1);
    hang(static_cast<Index>(corners_.size()) - 1, v);
  }
  return face;
}

void EditableMesh::hang(Index corner, Index v) {
  corners_[corner] = v;
  next_[corner] = first_[v];
  previous_[corner] = -1;
  if (first_[v] >= 0) previous_[first_[v]] = corner;
  first_[v] = corner;
  ++counts_[v];
}

void EditableMesh::unhang(Index corner) {
  const Index v = corners_[corner];
  if (next_[corner] >= 0) previous_[next_[corner]] = previous_[corner];
  (previous_[corner] >= 0 ? next_[previous_[corner]] : first_[v]) = next_[corner];
  --counts_[v];
}

void EditableMesh::setCorner(Index corner, Index v) {
  unhang(corner);
  hang(corner, v);
}

DerivedMesh EditableMesh::derived() const {
  DerivedMesh result;
  std::vector<Index> place(vertexCount(), -1);
  for (Index v = 0; v < vertexCount(); ++v) {
    const bool wasAlone = v < static_cast<Index>(wasUsed_.size()) && !wasUsed_[v];
    if (!isUsed(v) && !wasAlone) continue;
    place[v] = static_cast<Index>(result.vertexOrigin.size());
    result.vertexOrigin.push_back(origins_[v]);
  }
  result.mesh.positions.resize(result.vertexOrigin.size(), 3);
  for (Index v = 0; v < vertexCount(); ++v) {
    if (place[v] >= 0) result.mesh.positions.row(place[v]) = positions_[v].transpose();
  }
  for (Index f = 0; f < faceCount(); ++f) {
    if (isFace(f)) result.faceOrigin.push_back(faceOrigins_[f]);
  }
  result.mesh.triangles.resize(result.faceOrigin.size(), 3);
  for (Index f = 0, row = 0; f < faceCount(); ++f) {
    if (!isFace(f)) continue;
    for (int k = 0; k < 3; ++k) result.mesh.triangles(row, k) = place[corners_[3 * f + k]];
    ++row;
  }
  return result;
}

}  // namespace whittle
