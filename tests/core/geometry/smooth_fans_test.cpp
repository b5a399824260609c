#include "geometry/smooth_fans.h"

#include <doctest/doctest.h>

#include "geometry/surface.h"
#include "support/shapes.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

SmoothFans fansOf(const TriangleMesh& mesh) { return smoothFans(mesh.positions, mesh.triangles); }

/// How many vertices have so many fans.
Index countWith(Index fanCount, const SmoothFans& fans) {
  Index count = 0;
  for (Index v = 0; v + 1 < static_cast<Index>(fans.start.size()); ++v) count += fans.countAt(v) == fanCount;
  return count;
}

/// A roof of two slopes along x that meet at an angle (radians between their normals), as four faces.
TriangleMesh roof(double bend) {
  TriangleMesh mesh{Points(6, 3), Triangles(4, 3)};
  const double c = std::cos(bend / 2), s = std::sin(bend / 2);
  mesh.positions << 0, -c, -s, 1, -c, -s, 0, 0, 0, 1, 0, 0, 0, c, -s, 1, c, -s;
  mesh.triangles << 0, 1, 3, 0, 3, 2, 2, 3, 5, 2, 5, 4;
  return mesh;
}

}  // namespace

TEST_CASE("smooth surfaces, rims and all, have one fan a vertex") {
  for (const TriangleMesh& mesh : {sphere(1), bent(sphere(3)), bent(grid(6)), torus(16), animal(4)}) {
    const SmoothFans fans = fansOf(mesh);
    CHECK(fans.areVertices());
    CHECK(fans.count() == mesh.vertexCount());
  }
}

TEST_CASE("a block has three fans at its corners, two along its edges; areas and normals are those of its sides") {
  const TriangleMesh mesh = blocks({{0, 0, 0}}, 3);
  const SmoothFans fans = fansOf(mesh);
  CHECK(countWith(3, fans) == 8);
  CHECK(countWith(2, fans) == 24);
  CHECK(countWith(1, fans) == 24);
  const Scalars areas = barycentricAreas(mesh.positions, mesh.triangles, fans),
                ofVertices = barycentricAreas(mesh.positions, mesh.triangles),
                mixed = mixedVoronoiAreas(mesh.positions, mesh.triangles, fans);
  const Points normals = fanNormals(mesh.positions, mesh.triangles, fans);
  CHECK(mixed.sum() == doctest::Approx(6));
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    double area = 0;
    for (Index fan = fans.start[v]; fan < fans.start[v + 1]; ++fan) {
      area += areas[fan];
      CHECK(normals.row(fan).cwiseAbs().maxCoeff() == 1);
      CHECK(normals.row(fan).cwiseAbs().sum() == 1);
    }
    CHECK(area == doctest::Approx(ofVertices[v]));
  }
}

TEST_CASE("fans are cut between 54 and 56 degrees: an octagon is round, a hexagon is not") {
  CHECK(fansOf(roof(54 * EIGEN_PI / 180)).areVertices());
  CHECK(countWith(2, fansOf(roof(56 * EIGEN_PI / 180))) == 2);
  CHECK(countWith(3, fansOf(prism(6, 0))) == 12);
  CHECK(countWith(2, fansOf(prism(8, 0))) == 16);
}

TEST_CASE("where a surface has its other side up, its normal turns over and the fans are two") {
  CHECK(countWith(2, fansOf(moebiusStrip(30))) == 4);
}

TEST_CASE(
    "fans whose faces meet nowhere are apart unless they look one way, and an edge of three faces joins what bends "
    "little") {
  TriangleMesh tips{Points(5, 3), Triangles(2, 3)};  // two triangles that share a tip
  tips.positions << 0, 0, 0, 1, 0, 0, 1, 1, 0, -1, 0, 0, -1, -1, 0;
  tips.triangles << 0, 1, 2, 0, 3, 4;
  CHECK(fansOf(tips).countAt(0) == 1);
  tips.positions.row(4) << -1, 0, 1;
  CHECK(fansOf(tips).countAt(0) == 2);

  TriangleMesh fin = roof(0);  // with a face that stands on its ridge
  fin.positions.conservativeResize(7, 3);
  fin.positions.row(6) << 0.5, 0, 1;
  fin.triangles.conservativeResize(5, 3);
  fin.triangles.row(4) << 2, 3, 6;
  const SmoothFans fans = fansOf(fin);
  CHECK(fans.countAt(2) == 2);
  CHECK(fans.ofCorner(0, 2) == fans.ofCorner(2, 1));  // across the ridge, at vertex 3
  fin.triangles.row(4).swap(fin.triangles.row(0));
  CHECK(fansOf(fin).countAt(2) == 2);
}

TEST_CASE("a face without area is no edge: what lies on both sides of it meets") {
  TriangleMesh mesh{Points(5, 3), Triangles(3, 3)};  // a square, a sliver on its edge 1–3 whose middle is vertex 4
  mesh.positions << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0.5, 0.5, 0;
  mesh.triangles << 0, 1, 3, 1, 4, 3, 1, 2, 4;
  const SmoothFans fans = fansOf(mesh);
  CHECK(fans.countAt(1) == 1);
  CHECK(fans.countAt(3) == 1);
  // Both ways round a face that is nothing but rounding.
  mesh.positions.row(4) << 0.5 + 1e-8, 0.5, 1e-8;
  CHECK(fansOf(mesh).countAt(1) == 1);
  // A vertex of nothing else, and one of no face at all.
  mesh.triangles.conservativeResize(2, 3);
  mesh.triangles.row(0) << 0, 0, 1;
  CHECK(fansOf(mesh).areVertices());
}

TEST_CASE("vertices of one fan have the bits of vertex normals") {
  const TriangleMesh smooth = bent(sphere(3)), sharp = together(smooth, blocks({{0, 0, 0}}, 1), {3, 0, 0});
  const SmoothFans fans = fansOf(sharp);
  REQUIRE(!fans.areVertices());
  const Points ofFans = fanNormals(sharp.positions, sharp.triangles, fans),
               ofVertices = vertexNormals(sharp.positions, sharp.triangles);
  for (Index v = 0; v < smooth.vertexCount(); ++v) CHECK(ofFans.row(fans.start[v]) == ofVertices.row(v));
}
