#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace whittle::bench {

/// Collects sheets of quadrilaterals and welds them where they meet: shapes whose faces are about even.
class Patches {
 public:
  /// Cuts in two each of across × along quadrilaterals of the sheet place(u, v), u and v from 0 to 1, crosswise by turns.
  /// Sides show to ∂u × ∂v.
  template <typename Place>
  void add(int across, int along, Place place) {
    for (int j = 0; j < along; ++j) {
      for (int i = 0; i < across; ++i) cut(corners(across, along, i, j, false, place), (i + j) % 2 == 0);
    }
  }
  /// A sheet that closes in u, each row half a step further, as in remeshed tubes; `along` must be even.
  template <typename Place>
  void addStaggered(int across, int along, Place place) {
    for (int j = 0; j < along; ++j) {
      for (int i = 0; i < across; ++i) cut(corners(across, along, i, j, true, place), j % 2 == 0);
    }
  }

  TriangleMesh welded() const {
    TriangleMesh mesh{Points(static_cast<Index>(points_.size()), 3), Triangles(static_cast<Index>(faces_.size()), 3)};
    for (Index v = 0; v < mesh.vertexCount(); ++v) mesh.positions.row(v) = points_[v].transpose();
    for (Index f = 0; f < mesh.faceCount(); ++f) mesh.triangles.row(f) << faces_[f][0], faces_[f][1], faces_[f][2];
    return mesh;
  }

 private:
  using Quad = std::array<Vec3, 4>;

  template <typename Place>
  static Quad corners(int across, int along, int i, int j, bool isStaggered, Place place) {
    const auto at = [&](int a, int b) {
      const double shift = isStaggered && b % 2 == 1 ? 0.5 : 0;
      return Vec3(place((a + shift) / across, static_cast<double>(b) / along));
    };
    return {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
  }

  void cut(const Quad& quad, bool fromSecond) {
    std::array<Index, 4> v;
    for (int k = 0; k < 4; ++k) v[k] = vertexAt(quad[k]);
    if (fromSecond) {
      addFace({v[0], v[1], v[3]});
      addFace({v[1], v[2], v[3]});
    } else {
      addFace({v[0], v[1], v[2]});
      addFace({v[0], v[2], v[3]});
    }
  }
  void addFace(const std::array<Index, 3>& face) { faces_.push_back(face); }
  Index vertexAt(const Vec3& point) {
    // The shift keeps round coordinates off the borders of what is rounded alike.
    std::array<std::int64_t, 3> cell;
    for (int axis = 0; axis < 3; ++axis) cell[axis] = std::llround(1e6 * point[axis] + 0.377);
    const auto [place, isNew] = vertices_.try_emplace(cell, static_cast<Index>(points_.size()));
    if (isNew) points_.push_back(point);
    return place->second;
  }

  std::map<std::array<std::int64_t, 3>, Index> vertices_;
  std::vector<Vec3> points_;
  std::vector<std::array<Index, 3>> faces_;
};

}  // namespace whittle::bench
