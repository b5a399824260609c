#include <doctest/doctest.h>

#include <cmath>

#include "geometry/surface.h"
#include "session/session.h"
#include "support/allocations.h"
#include "support/runs.h"
#include "support/shapes.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

/// How far single-precision rotations may take two orders of the same arithmetic apart, for meshes of size about 2.
constexpr double kSingle = 2e-6;

struct Setup {
  std::string method = "cubic";
  double lambda = 0.4;
  double tolerance = 3e-3;
  int maxIterations = 300;
  Handles handles = {};
};

Run run(const TriangleMesh& mesh, const Setup& setup) {
  Session session;
  REQUIRE(session.load(mesh).ok());
  REQUIRE(session.select(setup.method).ok());
  if (setup.method == "cubic") REQUIRE(session.set("lambda", encoded(setup.lambda)).ok());
  REQUIRE(session.set("tolerance", encoded(setup.tolerance)).ok());
  REQUIRE(session.set("maxIterations", encoded(setup.maxIterations)).ok());
  REQUIRE(session.set("handles", encoded(setup.handles)).ok());
  REQUIRE(session.prepare().ok());
  return finish(session);
}

/// Mean angle between face normals and the nearest axis, area-weighted, in degrees: 0 for a box.
double angleToAxes(const Points& positions, const Triangles& triangles) {
  double sum = 0, area = 0;
  for (Index f = 0; f < triangles.rows(); ++f) {
    const Vec3 a = positions.row(triangles(f, 0)).transpose(), b = positions.row(triangles(f, 1)).transpose(),
               c = positions.row(triangles(f, 2)).transpose();
    const Vec3 n = (b - a).cross(c - a);
    if (n.norm() == 0) continue;
    sum += n.norm() * std::acos(std::min(1.0, n.cwiseAbs().maxCoeff() / n.norm()));
    area += n.norm();
  }
  return sum / area * 180 / EIGEN_PI;
}

/// But for single precision, of the energy and of the terms that cancel in it (about 1 in the unit frame).
void requireMonotone(const std::vector<double>& energies) {
  for (std::size_t k = 1; k < energies.size(); ++k)
    REQUIRE(energies[k] <= energies[k - 1] + 3e-8 * (std::abs(energies[0]) + 1));
}

double largestMove(const Points& a, const Points& b) { return (a - b).rowwise().norm().maxCoeff(); }

Handles handlesAt(const TriangleMesh& mesh, const std::vector<Index>& vertices, const Mat3& R, const Vec3& shift) {
  Handles handles{vertices, Points(vertices.size(), 3)};
  for (std::size_t h = 0; h < vertices.size(); ++h) {
    handles.targets.row(h) = (R * mesh.positions.row(vertices[h]).transpose() + shift).transpose();
  }
  return handles;
}

}  // namespace

TEST_CASE("without handles and without cubeness the input comes back") {
  for (const TriangleMesh& mesh :
       {bent(sphere(3)), bent(grid(8)), moebiusStrip(24), together(sphere(2), grid(5), {3, 1, 0})}) {
    for (const Setup& setup : {Setup{"arap"}, Setup{"cubic", 0}}) {
      const Run result = run(mesh, setup);
      CHECK(result.outcome == Outcome::converged);
      CHECK(largestMove(result.positions, mesh.positions) == 0);
    }
  }
}

TEST_CASE("handles moved rigidly carry the mesh with them") {
  const TriangleMesh mesh = bent(sphere(2));
  const Mat3 R = someRotation();
  const Vec3 shift(3, 4, 5);
  const Setup setup{"arap", 0, 1e-10, 20000, handlesAt(mesh, {0, 5, 17, 40}, R, shift)};
  const Run result = run(mesh, setup);
  const Points expected = (mesh.positions * R.transpose()).rowwise() + shift.transpose();
  CHECK(largestMove(result.positions, expected) < kSingle);
  requireMonotone(result.energies);
}

TEST_CASE("the energy never rises, handles are met") {
  const TriangleMesh mesh = bent(sphere(3));
  Handles handles = handlesAt(mesh, {0, 1, 7}, Mat3::Identity(), Vec3::Zero());
  handles.targets.row(1) += Eigen::RowVector3d(-0.7, 0.2, 0.4);
  for (const Setup& setup : {Setup{"arap", 0, 3e-3, 300, handles}, Setup{"cubic", 0, 3e-3, 300, handles},
                             Setup{"cubic", 0.4, 3e-3, 300, handles}, Setup{"cubic", 0.4}, Setup{"cubic", 1.5}}) {
    const Run result = run(mesh, setup);
    CHECK(result.energies.size() > 5);
    requireMonotone(result.energies);
    for (std::size_t h = 0; h < setup.handles.vertices.size(); ++h) {
      CHECK((result.positions.row(setup.handles.vertices[h]) - setup.handles.targets.row(h)).norm() < 1e-9);
    }
  }
}

TEST_CASE("cubeness grows with lambda and a sphere becomes a cube") {
  const TriangleMesh mesh = sphere(4);
  double last = angleToAxes(mesh.positions, mesh.triangles);
  for (const double lambda : {0.05, 0.1, 0.2, 0.4, 0.8}) {
    const Run result = run(mesh, {"cubic", lambda});
    const double angle = angleToAxes(result.positions, mesh.triangles);
    CHECK(angle < last);
    last = angle;
  }
  CHECK(last < 16);
}

TEST_CASE("the result does not depend on units or place") {
  const TriangleMesh mesh = bent(sphere(3));
  const Setup setup{"cubic", 0.3, 3e-3, 40};
  const Run plain = run(mesh, setup);
  for (const double scale : {1e-6, 0.0254, 1024.0}) {
    TriangleMesh scaled = mesh;
    const Eigen::RowVector3d shift(2 * scale, -3 * scale, scale);
    scaled.positions = (scale * mesh.positions).rowwise() + shift;
    const Run result = run(scaled, setup);
    const Points back = (result.positions.rowwise() - shift) / scale;
    CHECK(largestMove(back, plain.positions) < 1e-6);
    CHECK(result.energies.back() == doctest::Approx(plain.energies.back()).epsilon(1e-9));
  }
}

TEST_CASE("the same input gives the same bits") {
  const TriangleMesh mesh = together(bent(sphere(3)), moebiusStrip(20), {3, 0, 0});
  CHECK(run(mesh, {}).positions == run(mesh, {}).positions);
}

TEST_CASE("the order of the vertices does not matter") {
  const TriangleMesh mesh = bent(sphere(3));
  const Setup setup{"cubic", 0.3, 3e-3, 30};
  const Run plain = run(mesh, setup);
  const Run other = run(shuffled(mesh), setup);
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    REQUIRE((plain.positions.row(v) - other.positions.row(shuffledPlace(v, mesh.vertexCount()))).norm() < kSingle);
  }
}

TEST_CASE("turning by a symmetry of the cube turns the result") {
  const TriangleMesh mesh = bent(sphere(3));
  Mat3 quarter;
  quarter << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  TriangleMesh turned = mesh;
  turned.positions = mesh.positions * quarter.transpose();
  const Setup setup{"cubic", 0.4, 3e-3, 40};
  CHECK(largestMove(run(turned, setup).positions, run(mesh, setup).positions * quarter.transpose()) < kSingle);
}

TEST_CASE("every part keeps its centre, and none feels the other") {
  const TriangleMesh a = bent(sphere(3));
  const TriangleMesh b = bent(grid(9));
  const TriangleMesh both = together(a, b, {10, -4, 2});
  const Run result = run(both, {"cubic", 0.4, 3e-3, 60});
  const auto centroid = [](const Points& positions, const TriangleMesh& mesh) -> Vec3 {
    const Scalars areas = barycentricAreas(mesh.positions, mesh.triangles);
    return (areas.asDiagonal() * positions).colwise().sum().transpose() / areas.sum();
  };
  CHECK((centroid(result.positions.topRows(a.vertexCount()), a) - centroid(a.positions, a)).norm() < 4e-9);
  const TriangleMesh moved{b.positions.rowwise() + Eigen::RowVector3d(10, -4, 2), b.triangles};
  CHECK((centroid(result.positions.bottomRows(b.vertexCount()), moved) - centroid(moved.positions, moved)).norm() <
        4e-9);
}

TEST_CASE("vertices without a face stay to the bit") {
  TriangleMesh mesh = bent(sphere(2));
  mesh.positions.conservativeResize(mesh.vertexCount() + 1, 3);
  mesh.positions.bottomRows<1>() << 0.1, 0.2, 0.3;
  const Run result = run(mesh, {});
  CHECK(result.positions.bottomRows<1>() == mesh.positions.bottomRows<1>());
  CHECK(result.positions.allFinite());
}

TEST_CASE("zero-area, repeated and non-manifold faces do not break the solve") {
  TriangleMesh mesh = bent(sphere(3));
  const Index count = mesh.faceCount();
  mesh.triangles.conservativeResize(count + 4, 3);
  mesh.triangles.row(count) = mesh.triangles.row(3);
  mesh.triangles.row(count + 1) << 0, 0, 1;
  mesh.triangles.row(count + 2) << 0, 50, 120;  // a fin inside
  mesh.positions.conservativeResize(mesh.vertexCount() + 1, 3);
  const Index middle = mesh.vertexCount() - 1;
  const Index i = mesh.triangles(7, 0), j = mesh.triangles(7, 1);
  mesh.positions.row(middle) = 0.5 * (mesh.positions.row(i) + mesh.positions.row(j));
  mesh.triangles.row(count + 3) << i, j, middle;  // three in a line
  const Run result = run(mesh, {});
  CHECK(result.positions.allFinite());
  CHECK(result.outcome == Outcome::converged);
  requireMonotone(result.energies);
  CHECK(largestMove(result.positions, mesh.positions) < 1);
  const Vec3 a = result.positions.row(i).transpose(), b = result.positions.row(j).transpose();
  CHECK((result.positions.row(middle).transpose() - 0.5 * (a + b)).norm() < 0.05);
}

TEST_CASE("a step allocates nothing") {
  for (const char* method : {"cubic", "arap"}) {
    Session session;
    REQUIRE(session.load(bent(sphere(2))).ok());
    REQUIRE(session.select(method).ok());
    REQUIRE(session.prepare().ok());
    StepReport report;
    const long before = allocationCount();
    for (int step = 0; step < 5; ++step) REQUIRE(session.step(report).ok());
    CHECK(allocationCount() == before);
  }
}

TEST_CASE("a warm start goes on from where it is") {
  const TriangleMesh mesh = bent(sphere(3));
  Session session;
  REQUIRE(session.load(mesh).ok());
  REQUIRE(session.select("cubic").ok());
  const auto iterate = [&](double lambda) {
    REQUIRE(session.set("lambda", encoded(lambda)).ok());
    REQUIRE(session.prepare().ok());
    StepReport report;
    int iterations = 0;
    for (; report.outcome == Outcome::running; ++iterations) REQUIRE(session.step(report).ok());
    return iterations;
  };
  const int cold = iterate(0.4);
  CHECK(iterate(0.41) < cold / 2);
  session.restart();
  Points positions(mesh.vertexCount(), 3);
  session.copyPositions(positions.data());
  CHECK(positions == mesh.positions);
}
