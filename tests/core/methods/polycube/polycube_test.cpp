#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "geometry/rotation_fit.h"
#include "geometry/surface.h"
#include "methods/polycube/polycube.h"
#include "support/allocations.h"
#include "support/shapes.h"
#include "support/style_runs.h"
#include "support/surface_measures.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

/// Six sides and two ends.
GaussMapData prismStyle() {
  GaussMapData data;
  data.normals.resize(8, 3);
  for (int side = 0; side < 6; ++side)
    data.normals.row(side) << std::cos(side * EIGEN_PI / 3), 0, std::sin(side * EIGEN_PI / 3);
  data.normals.bottomRows<2>() << 0, 1, 0, 0, -1, 0;
  return data;
}

struct Boxed {
  GaussMapData directions = cubeStyle();
  double lambda = 1;
  double smoothing = 0.2;
  int maxIterations = 50;
};

void prepareBoxed(Session& session, const Boxed& boxed) {
  REQUIRE(session.select("polycube").ok());
  REQUIRE(session.set("directions", encoded(boxed.directions)).ok());
  REQUIRE(session.set("lambda", encoded(boxed.lambda)).ok());
  REQUIRE(session.set("smoothing", encoded(boxed.smoothing)).ok());
  REQUIRE(session.set("maxIterations", encoded(boxed.maxIterations)).ok());
  REQUIRE(session.prepare().ok());
}

Run carve(const TriangleMesh& mesh, const Boxed& boxed) {
  Session session;
  REQUIRE(session.load(mesh).ok());
  prepareBoxed(session, boxed);
  return finish(session);
}

double largestMove(const Points& a, const Points& b) { return (a - b).rowwise().norm().maxCoeff(); }

}  // namespace

TEST_CASE("the turn of a face is the plain fit") {
  Noise noise;
  for (const double lambda : {0.1, 1.0, 7.0}) {
    for (int trial = 0; trial < 50; ++trial) {
      const Vec3 n = noise.direction(), t = noise.direction();
      const Mat3 M = Mat3::Identity() - n * n.transpose() + lambda * n * t.transpose();
      const Mat3 R = Mat3::Identity() + rotationChangeToward(n, t, lambda);
      CHECK((R.transpose() * R - Mat3::Identity()).norm() < 1e-12);
      CHECK((R - fitRotation(M)).norm() < 1e-6);
    }
  }
  const Vec3 n = noise.direction();
  CHECK(rotationChangeToward(n, n, 3).isZero(0));
  CHECK(rotationChangeToward(n, -n, 3).isZero(0));
  CHECK(rotationChangeToward(n, noise.direction(), 0).isZero(0));
}

TEST_CASE("an animal becomes a polycube without folds") {
  const TriangleMesh mesh = animal(4);
  const double angle = angleToStyle(mesh.positions, mesh.triangles, GaussMap(cubeStyle()));
  for (const double smoothing : {0.0, 0.2}) {
    const Run result = carve(mesh, {cubeStyle(), 1, smoothing});
    const double now = angleToStyle(result.positions, mesh.triangles, GaussMap(cubeStyle()));
    const double volume = volumeInside(result.positions, mesh.triangles) / volumeInside(mesh.positions, mesh.triangles);
    const double within = shareWithin(10, cubeStyle().normals, result.positions, mesh.triangles);
    MESSAGE("smoothing " << smoothing << ": " << angle << "° before, " << now << "° after, " << within
                         << " within 10°, volume " << volume);
    CHECK(now < 2);
    CHECK(within > 0.97);
    CHECK(foldCount(result.positions, mesh.triangles) == 0);
    CHECK(volume > 0.55);
    CHECK(volume < 0.85);
    CHECK(result.energies.back() < 0.02 * result.energies.front());
  }
}

TEST_CASE("other directions make other boxes") {
  for (const TriangleMesh& mesh : {animal(4), torus(32)}) {
    for (const GaussMapData& directions : {prismStyle(), octahedronStyle()}) {
      const Run result = carve(mesh, {directions});
      CHECK(angleToStyle(result.positions, mesh.triangles, GaussMap(directions)) < 3.5);
      CHECK(foldCount(result.positions, mesh.triangles) == 0);
    }
  }
}

TEST_CASE("without lambda, or where all normals are right, nothing moves") {
  TriangleMesh squeezed = bent(grid(9));
  squeezed.positions.col(0) *= 0.03;  // its triangles are bad, and were
  for (const TriangleMesh& mesh : {bent(sphere(3)), squeezed, torus(14)}) {
    CHECK(largestMove(carve(mesh, {octahedronStyle(), 0, 1}).positions, mesh.positions) == 0);
  }
  const TriangleMesh box = longBox(6, 3);
  CHECK(largestMove(carve(box, Boxed()).positions, box.positions) < 1e-6);
}

TEST_CASE("turning directions and mesh together turns the polycube, another order of vertices is another order") {
  const TriangleMesh mesh = animal(3);
  Boxed boxed{octahedronStyle(), 1, 0.2, 15};
  boxed.directions.normals = (boxed.directions.normals * someRotation()).eval();
  const Points plain = carve(mesh, boxed).positions;

  const Points other = carve(shuffled(mesh), boxed).positions;
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    CHECK((other.row(shuffledPlace(v, mesh.vertexCount())) - plain.row(v)).norm() < 1e-4);
  }

  // About the axis of the turn that decides ties, which does not turn with the directions: about any other, a face within
  // 1e-3 radians of the border between two directions may fall to the other one, and with it what is around it.
  const Mat3 R = Eigen::AngleAxisd(1.1, GaussMap::kTieAxis).toRotationMatrix();
  boxed.directions.normals = (boxed.directions.normals * R.transpose()).eval();
  const Points turned = carve({mesh.positions * R.transpose(), mesh.triangles}, boxed).positions;
  CHECK(largestMove(turned, plain * R.transpose()) < 1e-3);
}

TEST_CASE("sides that lie between two directions stay flat, whatever rounding says") {
  const Mat3 turn = Eigen::AngleAxisd(EIGEN_PI / 4, Vec3::UnitZ()).toRotationMatrix();
  TriangleMesh mesh = blocks({{0, 0, 0}}, 10);
  mesh.positions = (mesh.positions * turn.transpose()).eval();
  const Points positions = carve(mesh, {}).positions;
  CHECK(bentPairCount(mesh, positions) == 0);
  CHECK(volumeInside(positions, mesh.triangles) > 0.85);
}

TEST_CASE("triangles that look another way than their surroundings pull nothing out of them") {
  TriangleMesh mesh = sphere(4);
  Noise noise;
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    const Eigen::RowVector3d p = mesh.positions.row(v);
    mesh.positions.row(v) *= 1 + 0.15 * std::sin(4 * p.x()) * std::cos(3 * p.y() + 1);
    for (int axis = 0; axis < 3; ++axis) mesh.positions(v, axis) += 0.03 * noise();  // a quarter of an edge
  }
  const Points positions = carve(mesh, {}).positions;
  CHECK(angleToStyle(positions, mesh.triangles, GaussMap(cubeStyle())) < 0.3);  // 1.5 by their own normals alone
  CHECK(foldCount(positions, mesh.triangles) == 0);
}

TEST_CASE("each part keeps its centre, and what has no normal its place") {
  const TriangleMesh one = animal(3), two = torus(16);
  TriangleMesh mesh = together(one, two, {4, 0, 0});
  const Index count = mesh.vertexCount();
  mesh.positions.conservativeResize(count + 1, 3);
  mesh.positions.bottomRows<1>() << 0, 3, 0;
  const Points result = carve(mesh, Boxed()).positions;
  CHECK(result.allFinite());
  CHECK(result.row(count) == mesh.positions.row(count));
  const auto middle = [&](const Points& positions) -> Vec3 {
    return positions.middleRows(one.vertexCount(), two.vertexCount()).colwise().mean();
  };
  CHECK((middle(result) - middle(mesh.positions)).norm() < 0.05);
  CHECK(largestMove(result, mesh.positions) > 0.1);
}

TEST_CASE("smoothing moves what became bad towards the mean of its ring") {
  const TriangleMesh rest = grid(5);
  Points positions = rest.positions;
  const Index inner = 12, rim = 2;
  positions.row(inner) += Eigen::RowVector3d(0.24, 0, 0);  // nearly onto its neighbour
  positions.row(rim) += Eigen::RowVector3d(0.24, 0, 0);
  const Points before = positions;
  RingSmoothing smoothing;
  smoothing.prepare(rest.positions, rest.triangles);
  smoothing.smooth(0.2, rest.triangles, positions);
  CHECK((positions.row(inner) - before.row(inner) - 0.2 * (rest.positions.row(inner) - before.row(inner))).norm() <
        1e-12);
  CHECK(positions.row(rim) == before.row(rim));
  CHECK(positions.row(6) == before.row(6));

  RingSmoothing content;
  content.prepare(before, rest.triangles);
  Points still = before;
  content.smooth(0.2, rest.triangles, still);
  CHECK(still == before);
  CHECK(triangleQuality({0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(0.75), 0}) == doctest::Approx(1));
  CHECK(triangleQuality({0, 0, 0}, {1, 0, 0}, {0.5, 0, 0}) == 0);
}

TEST_CASE("smoothing keeps the worst triangles better") {
  const TriangleMesh mesh = animal(4);
  const auto worst = [&](double smoothing) {
    const Points positions = carve(mesh, {cubeStyle(), 1, smoothing}).positions;
    double quality = 1;
    for (Index f = 0; f < mesh.faceCount(); ++f) {
      const auto at = [&](int k) -> Vec3 { return positions.row(mesh.triangles(f, k)).transpose(); };
      quality = std::min(quality, triangleQuality(at(0), at(1), at(2)));
    }
    return quality;
  };
  CHECK(worst(0.2) > 2 * worst(0));
}

TEST_CASE("a polycube has the same bits every time, and its steps allocate nothing") {
  const TriangleMesh mesh = animal(3);
  const Boxed boxed{cubeStyle(), 1, 0.2, 20};
  Session session;
  REQUIRE(session.load(mesh).ok());
  prepareBoxed(session, boxed);
  const Points first = finish(session).positions;
  REQUIRE(session.prepare().ok());  // from where the run before ended
  CHECK(finish(session).positions == first);
  CHECK(carve(mesh, boxed).positions == first);

  REQUIRE(session.prepare().ok());
  StepReport report;
  const long before = allocationCount();
  for (int step = 0; step < 5; ++step) REQUIRE(session.step(report).ok());
  CHECK(allocationCount() == before);
}

TEST_CASE("a polycube needs directions") {
  Session session;
  REQUIRE(session.load(sphere(1)).ok());
  REQUIRE(session.select("polycube").ok());
  const Status status = session.prepare();
  CHECK(status.code == Code::badParameter);
  CHECK(status.message.find("needs directions") != std::string::npos);
}
