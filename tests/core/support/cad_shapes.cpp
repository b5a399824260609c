#include "support/cad_shapes.h"

#include <cmath>

#include "support/shapes.h"

namespace whittle::testing {

namespace {

/// Points and faces as they come.
class Draft {
 public:
  Index point(double x, double y, double z) {
    points_.emplace_back(x, y, z);
    return static_cast<Index>(points_.size()) - 1;
  }
  void face(Index a, Index b, Index c) { faces_.push_back({a, b, c}); }
  /// A quadrilateral, cut from a to c.
  void quad(Index a, Index b, Index c, Index d) {
    face(a, b, c);
    face(a, c, d);
  }
  TriangleMesh mesh() const {
    TriangleMesh mesh{Points(points_.size(), 3), Triangles(faces_.size(), 3)};
    for (std::size_t v = 0; v < points_.size(); ++v) mesh.positions.row(v) = points_[v].transpose();
    for (std::size_t f = 0; f < faces_.size(); ++f) mesh.triangles.row(f) << faces_[f][0], faces_[f][1], faces_[f][2];
    return mesh;
  }

 private:
  std::vector<Vec3> points_;
  std::vector<std::array<Index, 3>> faces_;
};

}  // namespace

TriangleMesh drilledPlate(int holes, double radius, int segments, double height) {
  constexpr double kSide = 0.2;
  Draft draft;
  const auto corner = [&](int column, int row, int level) { return 4 * column + 2 * row + level; };
  for (int column = 0; column <= holes; ++column) {
    for (int row = 0; row < 2; ++row) {
      for (int level = 0; level < 2; ++level) draft.point(kSide * column, kSide * row, height * level);
    }
  }
  for (int hole = 0; hole < holes; ++hole) {
    // Corners counter-clockwise from the lower right, each with the quarter of the rim from −45° on.
    const std::array<std::array<int, 2>, 4> square = {{{hole + 1, 0}, {hole + 1, 1}, {hole, 1}, {hole, 0}}};
    std::vector<std::array<Index, 2>> rim;
    for (int i = 0; i < segments; ++i) {
      const double angle = EIGEN_PI * (2.0 * i / segments - 0.25);
      const double x = kSide * (hole + 0.5) + radius * std::cos(angle), y = kSide / 2 + radius * std::sin(angle);
      rim.push_back({draft.point(x, y, 0), draft.point(x, y, height)});
    }
    for (int i = 0; i < segments; ++i) {
      const auto [low, high] = rim[i];
      const auto [nextLow, nextHigh] = rim[(i + 1) % segments];
      draft.quad(low, high, nextHigh, nextLow);
      // A segment belongs to the corner that it begins nearest to.
      const auto nearest = [&](int k) { return (8 * k + segments) / (2 * segments) % 4; };
      const int quarter = nearest(i), next = nearest(i + 1);
      const auto [column, row] = square[quarter];
      draft.face(corner(column, row, 1), nextHigh, high);
      draft.face(corner(column, row, 0), low, nextLow);
      if (next == quarter) continue;
      const auto [otherColumn, otherRow] = square[next];
      draft.face(corner(column, row, 1), corner(otherColumn, otherRow, 1), nextHigh);
      draft.face(corner(otherColumn, otherRow, 0), corner(column, row, 0), nextLow);
    }
    draft.quad(corner(hole, 0, 0), corner(hole + 1, 0, 0), corner(hole + 1, 0, 1), corner(hole, 0, 1));
    draft.quad(corner(hole + 1, 1, 0), corner(hole, 1, 0), corner(hole, 1, 1), corner(hole + 1, 1, 1));
  }
  draft.quad(corner(0, 1, 0), corner(0, 0, 0), corner(0, 0, 1), corner(0, 1, 1));
  draft.quad(corner(holes, 0, 0), corner(holes, 1, 0), corner(holes, 1, 1), corner(holes, 0, 1));
  return draft.mesh();
}

TriangleMesh filletedBracket(double thick, double radius, int segments) {
  constexpr double kWidth = 0.4;
  std::vector<std::array<double, 2>> profile = {{0, 0}, {1, 0}, {1, thick}};
  for (int i = 0; i <= segments; ++i) {
    const double angle = EIGEN_PI / 2 * i / segments;
    profile.push_back({thick + radius * (1 - std::sin(angle)), thick + radius * (1 - std::cos(angle))});
  }
  profile.push_back({thick, 1});
  profile.push_back({0, 1});
  Draft draft;
  const Index count = static_cast<Index>(profile.size());
  for (const auto& [x, z] : profile) {
    draft.point(x, 0, z);
    draft.point(x, kWidth, z);
  }
  for (Index i = 0; i < count; ++i) {
    const Index next = (i + 1) % count;
    draft.quad(2 * i, 2 * i + 1, 2 * next + 1, 2 * next);
    if (i == 0 || next == 0) continue;
    draft.face(0, 2 * i, 2 * next);
    draft.face(1, 2 * next + 1, 2 * i + 1);
  }
  return draft.mesh();
}

TriangleMesh revolved(const std::vector<std::array<double, 2>>& profile, int segments, bool isClosed) {
  Draft draft;
  const int count = static_cast<int>(profile.size());
  std::vector<std::vector<Index>> rings;
  for (const auto& [radius, z] : profile) {
    std::vector<Index> ring;
    for (int i = 0; i < (radius > 0 ? segments : 1); ++i) {
      const double angle = 2 * EIGEN_PI * i / segments;
      ring.push_back(draft.point(radius * std::cos(angle), radius * std::sin(angle), z));
    }
    rings.push_back(ring);
  }
  for (int k = 0; k + (isClosed ? 0 : 1) < count; ++k) {
    const std::vector<Index>&low = rings[k], &high = rings[(k + 1) % count];
    for (int i = 0; i < segments; ++i) {
      const int next = (i + 1) % segments;
      if (low.size() == 1) {
        draft.face(low[0], high[next], high[i]);
      } else if (high.size() == 1) {
        draft.face(low[i], low[next], high[0]);
      } else {
        draft.quad(low[i], low[next], high[next], high[i]);
      }
    }
  }
  return draft.mesh();
}

TriangleMesh mug(int segments) {
  constexpr double kOuter = 0.4, kInner = 0.37, kHeight = 1, kFloor = 0.04;
  std::vector<std::array<double, 2>> profile = {{0, 0}, {kOuter, 0}};
  constexpr int kLip = 6;
  const double middle = (kOuter + kInner) / 2, half = (kOuter - kInner) / 2;
  for (int i = 0; i <= kLip; ++i) {
    const double angle = EIGEN_PI * i / kLip;
    profile.push_back({middle + half * std::cos(angle), kHeight - half + half * std::sin(angle)});
  }
  profile.push_back({kInner, kFloor});
  profile.push_back({0, kFloor});
  const TriangleMesh body = revolved(profile, segments, false);
  std::vector<std::array<double, 2>> tube;
  for (int i = 0; i < 16; ++i) {
    const double angle = 2 * EIGEN_PI * i / 16;
    tube.push_back({0.25 + 0.035 * std::cos(angle), 0.035 * std::sin(angle)});
  }
  TriangleMesh handle = revolved(tube, 24, true);
  const Points flat = handle.positions;
  handle.positions.col(1) = -flat.col(2);
  handle.positions.col(2) = flat.col(1);
  return together(body, handle, {kOuter, 0, 0.5});
}

}  // namespace whittle::testing
