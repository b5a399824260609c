#include "methods/alternating/bevels.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>

using namespace whittle;

namespace {

/// A sheet along y, 2 long, whose section is a line through points in (x, z); its columns are cut into so many rows.
TriangleMesh folded(const std::vector<std::array<double, 2>>& section, int rows) {
  const Index columns = static_cast<Index>(section.size());
  TriangleMesh mesh;
  mesh.positions.resize(columns * (rows + 1), 3);
  mesh.triangles.resize(2 * (columns - 1) * rows, 3);
  Index face = 0;
  for (Index j = 0; j <= rows; ++j) {
    for (Index i = 0; i < columns; ++i) {
      const Index v = j * columns + i;
      mesh.positions.row(v) << section[i][0], 2.0 * j / rows, section[i][1];
      if (j == rows || i + 1 == columns) continue;
      mesh.triangles.row(face++) << v, v + 1, v + columns + 1;
      mesh.triangles.row(face++) << v, v + columns + 1, v + columns;
    }
  }
  return mesh;
}

std::vector<CylinderPatch> bevelsOf(const TriangleMesh& mesh) {
  const MeshEdges edges(mesh.triangles, mesh.vertexCount());
  return bevels(mesh, facePairs(mesh.positions, mesh.triangles, edges));
}

}  // namespace

TEST_CASE("a narrow strip between two creases is a bevel, however it is cut and whichever way it bends") {
  for (const double up : {1.0, -1.0}) {
    for (const int rows : {1, 7}) {
      const TriangleMesh mesh = folded({{0, 0}, {1, 0}, {1.1, -0.1 * up}, {1.1, -1.1 * up}}, rows);
      const std::vector<CylinderPatch> found = bevelsOf(mesh);
      REQUIRE(found.size() == 1);
      CHECK(found[0].faces.size() == static_cast<std::size_t>(2 * rows));
      CHECK(found[0].radius == doctest::Approx(0.1 * std::sqrt(2)));
      CHECK(std::abs(found[0].axis[1]) == doctest::Approx(1));
      CHECK((found[0].point - Vec3(1.05, 1, -0.05 * up)).norm() < 1e-9);
    }
  }
}

TEST_CASE("what is as wide as its neighbours, bends both ways, hardly or by a right angle is no bevel") {
  std::vector<std::array<double, 2>> rod;
  const double eighth = EIGEN_PI / 4;
  for (int k = 0; k <= 8; ++k) rod.push_back({0.2 * std::cos(eighth * k), 0.2 * std::sin(eighth * k)});
  CHECK(bevelsOf(folded(rod, 4)).empty());
  CHECK(bevelsOf(folded({{0, 0}, {1, 0}, {1.1, -0.1}, {2.1, -0.1}}, 4)).empty());
  CHECK(bevelsOf(folded({{0, 0}, {1, 0}, {1.1, -0.01}, {2.1, -0.3}}, 4)).empty());
  CHECK(bevelsOf(folded({{0, 0}, {1, 0}, {1, -0.1}, {0, -0.1}}, 4)).empty());
  CHECK(bevelsOf(folded({{0, 0}, {1, 0}, {3, -2}, {3, -5}}, 4)).empty());
}
