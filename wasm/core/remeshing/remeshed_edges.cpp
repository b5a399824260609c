// Collapses and flips of `RemeshedSurface`.
#include <algorithm>
#include <cmath>

#include "remeshing/remeshed_surface.h"

namespace whittle {

namespace {

/// Edges shorter and longer than this times their target are too short and too long.
constexpr double kShort = 0.8, kLong = 4.0 / 3;
/// What a face may turn by a collapse and between two faces afterwards, as cosines: 30°.
constexpr double kTurn = 0.866, kBend = 0.866;
/// No collapse makes a face thinner than this, but where it was.
constexpr double kThin = 0.1, kThinner = 0.95;
/// How far the new edge of a flip may be from the old one, as a share of its target.
constexpr double kOff = 0.1;
/// Faces thinner than this have no normal that counts.
constexpr double kNoNormal = 1e-3;

double thicknessOf(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return longest > 0 ? (b - a).cross(c - a).norm() / longest : 0;
}

double cosine(const Vec3& a, const Vec3& b) {
  const double norms = a.norm() * b.norm();
  return norms > 0 ? a.dot(b) / norms : 1;
}

}  // namespace

bool RemeshedSurface::collapse(Index face, double scale) {
  for (Index h = 3 * face; h < 3 * face + 3; ++h) {
    const Index a = mesh_.tail(h), b = mesh_.head(h);
    if (edgeLength(a, b) < kShort * target(a, b) && collapseEdge(h, scale)) return true;
  }
  return false;
}

bool RemeshedSurface::canLeaveLine(Index a, Index b, Index line) const {
  if (lineOf_[b] != line) return false;
  const auto ends = lineNeighbours(b);
  const Index beyond = ends[ends[0] == a];
  return beyond >= 0 && beyond != a && lines_.deviation(line, placeOn(line, a), placeOn(line, beyond)) <= tolerance_;
}

bool RemeshedSurface::mergesCreases(Index a, Index b) const {
  bool isMerging = false;
  mesh_.forEachAlong(a, b, [&](Index h) {
    isMerging =
        isMerging || (mesh_.line(EditableMesh::nextInFace(h)) >= 0 && mesh_.line(EditableMesh::previousInFace(h)) >= 0);
  });
  return isMerging;
}

bool RemeshedSurface::collapseEdge(Index halfEdge, double scale) {
  const Index a = mesh_.tail(halfEdge), b = mesh_.head(halfEdge), line = mesh_.line(halfEdge);
  if (mergesCreases(a, b)) return false;
  const auto attempt = [&](Index kept, Index gone, const Vec3& place) {
    const Collapse collapse{kept, gone, place};
    if (!isGood(collapse, scale)) return false;
    apply(collapse);
    return true;
  };
  if (isFree(a) && isFree(b)) {
    return attempt(a, b, (mesh_.position(a) + mesh_.position(b)) / 2) || attempt(a, b, mesh_.position(a)) ||
           attempt(b, a, mesh_.position(b));
  }
  if (isFree(b)) return attempt(a, b, mesh_.position(a));
  if (isFree(a)) return attempt(b, a, mesh_.position(b));
  if (line < 0) return false;
  return (canLeaveLine(a, b, line) && attempt(a, b, mesh_.position(a))) ||
         (canLeaveLine(b, a, line) && attempt(b, a, mesh_.position(b)));
}

bool RemeshedSurface::isGood(const Collapse& collapse, double scale) {
  const Index kept = collapse.kept, gone = collapse.gone;
  const Vec3& place = collapse.place;
  bool isShortEnough = true;
  mesh_.forEachCorner(gone, [&](Index corner) {
    for (const Index other : {mesh_.head(corner), mesh_.opposite(corner)}) {
      if (other == kept) continue;
      const double length = (mesh_.position(other) - place).norm();
      const double most = std::max(kLong * scale * target(kept, other), edgeLength(gone, other));
      isShortEnough = isShortEnough && length <= most;
    }
  });
  const bool isMoved = place != mesh_.position(kept);
  return isShortEnough && keepsShapes(gone, collapse) && (!isMoved || keepsShapes(kept, collapse)) &&
         mesh_.canCollapse(kept, gone) && keepsBends(collapse);
}

bool RemeshedSurface::keepsShapes(Index v, const Collapse& collapse) const {
  const Index other = v == collapse.gone ? collapse.kept : collapse.gone;
  bool isKept = true;
  double before = 1, after = 1;
  mesh_.forEachCorner(v, [&](Index corner) {
    const Index b = mesh_.head(corner), c = mesh_.opposite(corner);
    const double old = thicknessOf(mesh_.position(v), mesh_.position(b), mesh_.position(c));
    before = std::min(before, old);
    if (!isKept || b == other || c == other) return;
    after = std::min(after, thicknessOf(collapse.place, mesh_.position(b), mesh_.position(c)));
    const Vec3 turned = mesh_.areaNormal(faceOf(corner), v, collapse.place);
    isKept = old < kNoNormal || cosine(turned, mesh_.areaNormal(faceOf(corner))) > kTurn;
  });
  return isKept && (after > kThin || after > kThinner * before);
}

Vec3 RemeshedSurface::normalAfter(Index face, const Collapse& collapse) const {
  const Vec3 gone = mesh_.areaNormal(face, collapse.gone, collapse.place);
  for (int k = 0; k < 3; ++k) {
    if (mesh_.vertex(3 * face + k) == collapse.kept) return mesh_.areaNormal(face, collapse.kept, collapse.place);
  }
  return gone;
}

bool RemeshedSurface::keepsBends(const Collapse& collapse) const {
  bool isKept = true;
  const auto isBeside = [&](Index face) {  // the edge that goes
    int ends = 0;
    for (int k = 0; k < 3; ++k) {
      const Index v = mesh_.vertex(3 * face + k);
      ends += v == collapse.kept || v == collapse.gone;
    }
    return ends == 2;
  };
  const auto compare = [&](Index face, Index other) {
    if (isBeside(face) || isBeside(other)) return;
    const double before = cosine(mesh_.areaNormal(face), mesh_.areaNormal(other));
    const double after = cosine(normalAfter(face, collapse), normalAfter(other, collapse));
    isKept = isKept && after >= std::min(kBend, before);
  };
  for (const Index v : {collapse.gone, collapse.kept}) {
    if (v == collapse.kept && collapse.place == mesh_.position(v)) continue;
    mesh_.forEachCorner(v, [&](Index corner) {
      for (const Index h : {corner, EditableMesh::nextInFace(corner)}) {
        const Index other = isKept && mesh_.line(h) < 0 ? mesh_.twin(h) : -1;
        if (other >= 0) compare(faceOf(corner), faceOf(other));
      }
    });
  }
  mesh_.forEachAlong(collapse.kept, collapse.gone, [&](Index h) {
    const Index in = EditableMesh::nextInFace(h), out = EditableMesh::previousInFace(h);
    if (!isKept || mesh_.line(in) >= 0 || mesh_.line(out) >= 0) return;
    const Index one = mesh_.twin(in), other = mesh_.twin(out);
    if (one >= 0 && other >= 0) compare(faceOf(one), faceOf(other));
  });
  return isKept;
}

void RemeshedSurface::apply(const Collapse& collapse) {
  const auto& [kept, gone, place] = collapse;
  wanted_[kept] = std::min(wanted_[kept], wanted_[gone]);
  sizes_[kept] = std::min(sizes_[kept], sizes_[gone]);
  mesh_.move(kept, place);
  mesh_.collapse(kept, gone);
}

bool RemeshedSurface::flip(Index face) {
  for (Index h = 3 * face; h < 3 * face + 3; ++h) {
    if (mesh_.line(h) >= 0 || mesh_.tail(h) > mesh_.head(h)) continue;  // its twin comes along as well
    const Index other = mesh_.twin(h);
    if (other < 0 || isDelaunay(h, other) || !flipsWell(h, other) || !mesh_.canFlip(h)) continue;
    mesh_.flip(h);
    return true;
  }
  return false;
}

bool RemeshedSurface::isDelaunay(Index halfEdge, Index other) const {
  const Vec3 &a = mesh_.position(mesh_.tail(halfEdge)), &b = mesh_.position(mesh_.head(halfEdge)),
             &c = mesh_.position(mesh_.opposite(halfEdge)), &d = mesh_.position(mesh_.opposite(other));
  // The angles at c and d have no more than 180° together.
  const Vec3 ca = a - c, cb = b - c, da = a - d, db = b - d;
  const double sum = ca.dot(cb) * da.cross(db).norm() + da.dot(db) * ca.cross(cb).norm();
  return sum >= -1e-6 * std::sqrt(ca.squaredNorm() * cb.squaredNorm() * da.squaredNorm() * db.squaredNorm());
}

bool RemeshedSurface::flipsWell(Index halfEdge, Index other) const {
  const Index cv = mesh_.opposite(halfEdge), dv = mesh_.opposite(other);
  const Vec3 &a = mesh_.position(mesh_.tail(halfEdge)), &b = mesh_.position(mesh_.head(halfEdge)),
             &c = mesh_.position(cv), &d = mesh_.position(dv);
  const Vec3 first = mesh_.areaNormal(faceOf(halfEdge)), second = mesh_.areaNormal(faceOf(other));
  const Vec3 one = (b - d).cross(c - d), two = (a - c).cross(d - c);  // of (d, b, c) and (c, a, d)
  const double thinBefore = std::min(thicknessOf(a, b, c), thicknessOf(b, a, d));
  const double thinAfter = std::min(thicknessOf(d, b, c), thicknessOf(c, a, d));
  if (thinAfter < kNoNormal && thinAfter <= thinBefore) return false;
  const Vec3 both = first + second;
  if (cosine(one, both) < kTurn || cosine(two, both) < kTurn) return false;
  const double bend = thinBefore < kNoNormal ? 1 : cosine(first, second);
  if (cosine(one, two) < std::min(kBend, bend)) return false;
  const Vec3 across = (b - a).cross(d - c);
  const double norm = across.norm();
  return norm > 0 && std::abs(across.dot(c - a)) <= kOff * target(cv, dv) * norm;
}

}  // namespace whittle
