#include "remeshing/clean.h"

#include <algorithm>
#include <array>
#include <utility>

#include "mesh/validate.h"
#include "remeshing/editable_mesh.h"

namespace whittle {

namespace {

/// Rounds over all slivers at most: a mended one may leave another for the next.
constexpr int kRounds = 30;
/// The short side of a needle, at most so many times its height; otherwise it is a cap.
constexpr double kNeedle = 2;
/// No side longer than this share of the longest is collapsed.
constexpr double kShort = 3 * kSliver;
/// Cosine of the angle within which two normals belong to one smooth surface, 35°.
constexpr double kSmooth = 0.82;
/// Cosine of the angle between the two sides of a wall, at which they are not to be put together.
constexpr double kWall = -0.5;

/// Shape of a triangle, its sides from corner k to k + 1.
struct Shape {
  int longest = 0, shortest = 0;
  double lengths[3];
  double height = 0;  // over the longest side

  double thickness() const { return lengths[longest] > 0 ? height / lengths[longest] : 0; }
};

Shape shapeOf(const std::array<Vec3, 3>& corners) {
  Shape shape;
  for (int k = 0; k < 3; ++k) {
    shape.lengths[k] = (corners[(k + 1) % 3] - corners[k]).norm();
    if (shape.lengths[k] > shape.lengths[shape.longest]) shape.longest = k;
    if (shape.lengths[k] < shape.lengths[shape.shortest]) shape.shortest = k;
  }
  const double longest = shape.lengths[shape.longest];
  if (longest > 0) shape.height = (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm() / longest;
  return shape;
}

class Cleaner {
 public:
  explicit Cleaner(const TriangleMesh& mesh) : mesh_(mesh) {}

  void dropUseless();
  void mendSlivers();
  CleanMesh result() const;

 private:
  std::array<Vec3, 3> cornersOf(Index face) const;
  std::array<Vec3, 3> cornersWith(Index face, Index v, const Vec3& elsewhere) const;
  Shape shape(Index face) const { return shapeOf(cornersOf(face)); }
  bool isSliver(Index face) const { return shape(face).thickness() < kSliver; }
  Vec3 normal(Index face) const { return mesh_.areaNormal(face).normalized(); }

  bool mend(Index face);
  /// Moves the end b of a short side into a, if that harms nothing.
  bool collapse(Index a, Index b);
  /// Cuts a cap away: its obtuse corner becomes a vertex of the faces beyond its long side.
  bool cutCap(Index face, const Shape& shape);
  bool canPutInto(Index beyond, Index cap, Index halfEdge) const;
  /// Whether a cap's long side and its obtuse corner are on two sides of a wall, by the normal beyond the side: the
  /// faces beside the cap know which way is out even where some are turned over, otherwise those at the corner do.
  bool isAcrossWall(const Vec3& beyond, bool isTurned, Index halfEdge) const;
  bool isHeld(Index a, Index b);
  /// Collapses a short side; of its ends stays the one at which more comes together.
  bool collapseEither(Index a, Index b);
  /// Whether all ways that the surface at b looks, it looks at a as well: b is no corner that a is not.
  bool looksAsAt(Index a, Index b) const;
  /// Whether a and b are on two sides of a wall.
  bool isWall(Index a, Index b) const;
  bool keepsFaces(Index a, Index b) const;
  /// Calls `visit(normal)` for the faces at v that are no slivers, but for those that `other` is on; until it says true.
  template <typename Visit>
  bool anyNormal(Index v, Index other, Visit&& visit) const;
  /// The other ends of edges at v that have not two faces.
  const std::vector<Index>& seams(Index v);

  EditableMesh mesh_;
  std::vector<Index> ends_;  // scratch
  Index mended_ = 0;
};

std::array<Vec3, 3> Cleaner::cornersOf(Index face) const {
  return {mesh_.position(mesh_.vertex(3 * face)), mesh_.position(mesh_.vertex(3 * face + 1)),
          mesh_.position(mesh_.vertex(3 * face + 2))};
}

std::array<Vec3, 3> Cleaner::cornersWith(Index face, Index v, const Vec3& elsewhere) const {
  std::array<Vec3, 3> corners = cornersOf(face);
  for (int k = 0; k < 3; ++k) {
    if (mesh_.vertex(3 * face + k) == v) corners[k] = elsewhere;
  }
  return corners;
}

template <typename Visit>
bool Cleaner::anyNormal(Index v, Index other, Visit&& visit) const {
  bool isFound = false;
  mesh_.forEachCorner(v, [&](Index corner) {
    if (isFound || mesh_.head(corner) == other || mesh_.opposite(corner) == other || isSliver(faceOf(corner))) return;
    isFound = visit(normal(faceOf(corner)));
  });
  return isFound;
}

void Cleaner::dropUseless() {
  std::vector<std::array<Index, 4>> faces;  // corners in order, and the face
  for (Index f = 0; f < mesh_.faceCount(); ++f) {
    std::array<Index, 4> face = {mesh_.vertex(3 * f), mesh_.vertex(3 * f + 1), mesh_.vertex(3 * f + 2), f};
    std::sort(face.begin(), face.begin() + 3);
    if (face[0] != face[1] && face[1] != face[2]) {
      faces.push_back(face);
      continue;
    }
    mesh_.removeFace(f);
    ++mended_;
  }
  std::sort(faces.begin(), faces.end());
  for (std::size_t i = 1; i < faces.size(); ++i) {
    if (!std::equal(faces[i].begin(), faces[i].begin() + 3, faces[i - 1].begin())) continue;
    mesh_.removeFace(faces[i][3]);
    ++mended_;
  }
}

void Cleaner::mendSlivers() {
  bool isChanged = true;
  for (int round = 0; isChanged && round < kRounds; ++round) {
    isChanged = false;
    for (Index f = 0, count = mesh_.faceCount(); f < count; ++f) {
      if (!mesh_.isFace(f) || !isSliver(f) || !mend(f)) continue;
      isChanged = true;
      ++mended_;
    }
  }
  for (Index f = 0; f < mesh_.faceCount(); ++f) {
    if (!mesh_.isFace(f) || shape(f).thickness() > kDegenerateThickness) continue;
    mesh_.removeFace(f);
    ++mended_;
  }
}

bool Cleaner::mend(Index face) {
  const Shape form = shape(face);
  const Index a = mesh_.tail(3 * face + form.shortest), b = mesh_.head(3 * face + form.shortest);
  const bool isShort = form.lengths[form.shortest] <= kShort * form.lengths[form.longest];
  const bool isNeedle = form.lengths[form.shortest] <= kNeedle * form.height;
  if (!isNeedle && cutCap(face, form)) return true;
  return isShort && collapseEither(std::min(a, b), std::max(a, b));
}

const std::vector<Index>& Cleaner::seams(Index v) {
  ends_.clear();
  mesh_.forEachCorner(v, [&](Index corner) {
    for (const Index end : {mesh_.head(corner), mesh_.opposite(corner)}) {
      if (mesh_.faceCountAlong(v, end) == 2) continue;
      if (std::find(ends_.begin(), ends_.end(), end) == ends_.end()) ends_.push_back(end);
    }
  });
  return ends_;
}

bool Cleaner::isHeld(Index a, Index b) {
  const std::vector<Index>& ends = seams(b);
  if (ends.empty()) return false;
  if (ends.size() != 2 || (ends[0] != a && ends[1] != a)) return true;
  // On a border or a seam that goes on: straight enough, or so fine a bend that the other end may have it.
  const Vec3 in = mesh_.position(b) - mesh_.position(a);
  const Vec3 out = mesh_.position(ends[ends[0] == a]) - mesh_.position(b);
  return in.squaredNorm() > 0 && in.dot(out) < kSmooth * in.norm() * out.norm();
}

bool Cleaner::looksAsAt(Index a, Index b) const {
  return !anyNormal(b, a, [&](const Vec3& own) {
    bool isCovered = false;
    mesh_.forEachCorner(a, [&](Index corner) {
      const Index face = faceOf(corner);
      isCovered = isCovered || (shape(face).thickness() > kDegenerateThickness && normal(face).dot(own) > kSmooth);
    });
    return !isCovered;
  });
}

bool Cleaner::isWall(Index a, Index b) const {
  return anyNormal(b, a, [&](const Vec3& own) {
    return anyNormal(a, b, [&](const Vec3& other) { return own.dot(other) < kWall; });
  });
}

bool Cleaner::keepsFaces(Index a, Index b) const {
  bool isKept = true;
  mesh_.forEachCorner(b, [&](Index corner) {
    const Index face = faceOf(corner);
    if (!isKept || mesh_.head(corner) == a || mesh_.opposite(corner) == a) return;
    const std::array<Vec3, 3> moved = cornersWith(face, b, mesh_.position(a));
    if (shapeOf(moved).thickness() < kSliver) {
      isKept = isSliver(face);
      return;
    }
    const Vec3 turned = (moved[1] - moved[0]).cross(moved[2] - moved[0]).normalized();
    if (!isSliver(face)) {
      isKept = turned.dot(normal(face)) > kSmooth;
    } else {
      const auto suits = [&](const Vec3& other) { return turned.dot(other) > kSmooth; };
      const auto any = [](const Vec3&) { return true; };
      isKept = anyNormal(a, b, suits) || anyNormal(b, a, suits) || (!anyNormal(a, b, any) && !anyNormal(b, a, any));
    }
  });
  return isKept;
}

bool Cleaner::collapse(Index a, Index b) {
  if (isHeld(a, b) || !keepsFaces(a, b) || !mesh_.canCollapse(a, b)) return false;
  mesh_.collapse(a, b);
  return true;
}

bool Cleaner::collapseEither(Index a, Index b) {
  if (isWall(a, b)) return false;
  for (const auto& [kept, gone] : {std::pair(a, b), std::pair(b, a)}) {
    if (looksAsAt(kept, gone) && collapse(kept, gone)) return true;
  }
  return collapse(a, b) || collapse(b, a);
}

bool Cleaner::canPutInto(Index beyond, Index cap, Index halfEdge) const {
  const Index c = mesh_.opposite(halfEdge), face = faceOf(beyond), d = mesh_.opposite(beyond);
  const Index a = mesh_.tail(beyond), b = mesh_.head(beyond);
  if (d == c || mesh_.hasFace(a, c, d) || mesh_.hasFace(c, b, d)) return false;
  const Shape first = shapeOf(cornersWith(face, b, mesh_.position(c))),
              second = shapeOf(cornersWith(face, a, mesh_.position(c)));
  const double thinnest = std::min(first.thickness(), second.thickness());
  const double before = shape(cap).thickness();
  if (isSliver(face)) return thinnest > std::min(before, shape(face).thickness());
  if (thinnest <= before) return false;
  const Vec3 own = normal(face);
  const auto isKept = [&](Index end) {
    return mesh_.areaNormal(face, end, mesh_.position(c)).normalized().dot(own) > kSmooth;
  };
  return isKept(a) && isKept(b) && !isAcrossWall(own, mesh_.tail(beyond) == mesh_.tail(halfEdge), halfEdge);
}

bool Cleaner::isAcrossWall(const Vec3& beyond, bool isTurned, Index halfEdge) const {
  bool isFound = false, isFacing = false;
  const auto compare = [&](const Vec3& other, bool isOtherTurned) {
    isFound = true;
    isFacing = isFacing || (isTurned == isOtherTurned ? 1 : -1) * beyond.dot(other) > kWall;
  };
  for (const Index side : {mesh_.nextInFace(halfEdge), mesh_.previousInFace(halfEdge)}) {
    const Index h = mesh_.twin(side);
    if (h >= 0 && !isSliver(faceOf(h))) compare(normal(faceOf(h)), mesh_.tail(h) == mesh_.tail(side));
  }
  if (!isFound) {
    anyNormal(mesh_.opposite(halfEdge), -1, [&](const Vec3& other) {
      compare(other, isTurned);
      return false;
    });
  }
  return isFound && !isFacing;
}

bool Cleaner::cutCap(Index face, const Shape& shape) {
  const Index halfEdge = 3 * face + shape.longest, a = mesh_.tail(halfEdge), b = mesh_.head(halfEdge);
  const Index c = mesh_.opposite(halfEdge);
  bool isGood = true;
  Index others = 0;
  mesh_.forEachAlong(a, b, [&](Index h) {
    if (h == halfEdge) return;
    ++others;
    isGood = isGood && canPutInto(h, face, halfEdge);
  });
  const bool isLoose = mesh_.faceCountAlong(b, c) == 1 && mesh_.faceCountAlong(c, a) == 1;
  if (!isGood || (others == 0 && isLoose)) return false;
  mesh_.removeFace(face);
  if (others > 0) mesh_.splitEdge(a, b, c);
  return true;
}

CleanMesh Cleaner::result() const {
  CleanMesh result{mesh_.derived(), mended_, {}};
  for (Index f = 0; f < result.derived.mesh.faceCount(); ++f) {
    if (thickness(result.derived.mesh, f) < kSliver) result.unmended.push_back(f);
  }
  return result;
}

}  // namespace

CleanMesh clean(const TriangleMesh& mesh) {
  Cleaner cleaner(mesh);
  cleaner.dropUseless();
  cleaner.mendSlivers();
  CleanMesh result = cleaner.result();
  if (result.mended == 0) result.derived = DerivedMesh::same(mesh);
  return result;
}

}  // namespace whittle
