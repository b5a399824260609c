#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

#include "mesh/adjacency.h"
#include "mesh/edges.h"
#include "mesh/unit_frame.h"
#include "mesh/validate.h"
#include "support/shapes.h"

using namespace whittle;
using namespace whittle::testing;

TEST_CASE("a good mesh passes the door and is reported") {
  const TriangleMesh mesh = together(sphere(2), grid(4), {5, 0, 0});
  REQUIRE(validate(mesh).ok());
  const MeshReport report = inspect(mesh);
  CHECK(report.vertices == 66 + 16);
  CHECK(report.faces == 128 + 18);
  CHECK(report.components == 2);
  CHECK(report.boundaryEdges == 12);
  CHECK(report.nonManifoldEdges == 0);
  CHECK(report.degenerateFaces == 0);
  CHECK(report.max.x() == doctest::Approx(6));
}

TEST_CASE("the door refuses and names the element") {
  TriangleMesh mesh = grid(3);
  const auto refused = [](const TriangleMesh& bad, Code code, Index element) {
    const Status status = validate(bad);
    CHECK(status.code == code);
    CHECK(status.element.index == element);
    CHECK(status.message.size() > 20);
  };
  refused({mesh.positions, Triangles(0, 3)}, Code::noFaces, -1);

  TriangleMesh outOfRange = mesh;
  outOfRange.triangles(2, 1) = 9;
  refused(outOfRange, Code::indexOutOfRange, 2);
  outOfRange.triangles(2, 1) = -1;
  refused(outOfRange, Code::indexOutOfRange, 2);

  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    TriangleMesh notFinite = mesh;
    notFinite.positions(4, 2) = bad;
    refused(notFinite, Code::notFinite, 4);
  }
  TriangleMesh huge = mesh;
  huge.positions *= 1e200;
  refused(huge, Code::notFinite, -1);

  TriangleMesh point = mesh;
  point.positions.setConstant(7);
  refused(point, Code::zeroExtent, -1);
  TriangleMesh line = mesh;
  line.positions.rightCols<2>().setZero();
  refused(line, Code::zeroExtent, -1);

  refused({Points::Zero(2'500'001, 3), mesh.triangles}, Code::tooLarge, -1);
}

TEST_CASE("what is odd but workable is counted") {
  TriangleMesh mesh = grid(3);
  mesh.positions.conservativeResize(11, 3);  // two vertices without a face
  mesh.positions.bottomRows<2>().setOnes();
  const Index count = mesh.faceCount();
  mesh.triangles.conservativeResize(count + 3, 3);
  mesh.triangles.row(count) = mesh.triangles.row(0).reverse();  // a duplicate, turned over
  mesh.triangles.row(count + 1) << 4, 4, 5;                     // one vertex twice
  mesh.triangles.row(count + 2) << 3, 4, 5;                     // three in a line
  REQUIRE(validate(mesh).ok());
  const MeshReport report = inspect(mesh);
  CHECK(report.isolatedVertices == 2);
  CHECK(report.degenerateFaces == 2);
  CHECK(report.nonManifoldEdges > 0);
  CHECK(report.components == 1);
}

TEST_CASE("parts are numbered by their first vertex") {
  Triangles triangles(2, 3);
  triangles << 5, 1, 3, 4, 2, 0;
  const Components parts = connectedComponents(triangles, 7);
  CHECK(parts.count == 3);
  CHECK(parts.ofVertex == std::vector<Index>{0, 1, 0, 1, 0, 1, 2});
}

TEST_CASE("the unit frame is a similarity and undoes itself") {
  TriangleMesh mesh = bent(sphere(2));
  mesh.positions = (mesh.positions * 250).rowwise() + Eigen::RowVector3d(1e4, -2e4, 3e3);
  const UnitFrame frame = UnitFrame::of(mesh);
  Vec3 mean = Vec3::Zero();
  Eigen::AlignedBox3d box;
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    const Vec3 p = mesh.positions.row(v).transpose();
    mean += frame.toUnit(p) / mesh.vertexCount();
    box.extend(frame.toUnit(p));
    CHECK((frame.toFile(frame.toUnit(p)) - p).norm() < 1e-10);
  }
  CHECK(mean.norm() < 1e-12);
  CHECK(box.sizes().maxCoeff() == doctest::Approx(1));
}

TEST_CASE("only what faces use must be finite, and only that has a box") {
  TriangleMesh mesh = grid(3);
  mesh.positions.conservativeResize(11, 3);
  mesh.positions.row(9).setConstant(std::numeric_limits<double>::quiet_NaN());
  mesh.positions.row(10).setConstant(1e308);
  CHECK(validate(mesh).ok());
  CHECK(inspect(mesh).max == Vec3(1, 1, 0));
}

TEST_CASE("far strays do not count for the unit frame, whatever the axis; what is near does") {
  const TriangleMesh body = sphere(3);
  const UnitFrame alone = UnitFrame::of(body);
  TriangleMesh speck = sphere(0);
  speck.positions *= 1e-3;
  for (const Vec3& far : {Vec3(3e4, 0, 0), Vec3(-2, -5e3, 1), Vec3(1e7, 1e7, 1e7)}) {
    const UnitFrame frame = UnitFrame::of(together(body, speck, far));
    CHECK(frame.scale == alone.scale);
    CHECK(frame.center == alone.center);
    CHECK(inspect(together(body, speck, far)).farVertices == speck.vertexCount());
  }
  const TriangleMesh two = together(together(body, speck, Vec3(1e4, 0, 0)), speck, Vec3(0, 0, -1e5));
  CHECK(UnitFrame::of(two).scale == alone.scale);
  CHECK(UnitFrame::of(together(body, speck, Vec3(20, 0, 0))).scale == doctest::Approx(21).epsilon(0.01));
  CHECK(UnitFrame::of(together(body, body, Vec3(150, 0, 0))).scale == doctest::Approx(152));
}

TEST_CASE("a typical part is that of the middle vertex") {
  CHECK(inspect(sphere(3)).typicalPart == 258);
  CHECK(inspect(sphere(3)).farVertices == 0);
  CHECK(inspect(together(sphere(3), sphere(1), Vec3(3, 0, 0))).typicalPart == 258);
  TriangleMesh many = sphere(1);
  for (int n = 1; n < 30; ++n) many = together(many, sphere(1), Vec3(3 * n, 0, 0));
  CHECK(inspect(together(many, sphere(3), Vec3(0, 5, 0))).typicalPart == 18);
}

TEST_CASE("edges know their half edges, on borders and where three faces meet") {
  Triangles triangles(4, 3);
  triangles << 0, 1, 2, 1, 0, 3, 0, 1, 4, 2, 2, 5;
  const MeshEdges edges(triangles, 6);
  REQUIRE(edges.count() == 8);
  CHECK(edges.ends[0] == std::array<Index, 2>{0, 1});
  CHECK(std::vector<Index>(edges.halfEdges.begin(), edges.halfEdges.begin() + 3) == std::vector<Index>{0, 3, 6});
  CHECK(std::is_sorted(edges.ends.begin(), edges.ends.end()));
  CHECK(edges.ofHalfEdge[9] == -1);
  CHECK(edges.ofHalfEdge[10] == edges.ofHalfEdge[11]);

  const TriangleMesh torus = whittle::testing::torus(9);
  const MeshEdges closed(torus.triangles, torus.vertexCount());
  CHECK(closed.count() == 3 * 81);
  for (Index e = 0; e < closed.count(); ++e) {
    REQUIRE(closed.faceCountAt(e) == 2);
    for (Index place = closed.start[e]; place < closed.start[e + 1]; ++place) {
      const Index h = closed.halfEdges[place], f = faceOf(h);
      CHECK(closed.ofHalfEdge[h] == e);
      CHECK(std::minmax(torus.triangles(f, tailCorner(h)), torus.triangles(f, headCorner(h))) ==
            std::minmax(closed.ends[e][0], closed.ends[e][1]));
    }
  }
}
