#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "geometry/surface.h"
#include "methods/spherical/moebius.h"
#include "methods/spherical/sphere_topology.h"
#include "session/session.h"
#include "support/runs.h"
#include "support/shapes.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

Run flow(const TriangleMesh& mesh, double timeStep = 1e-3, int maxIterations = 300) {
  Session session;
  REQUIRE(session.load(mesh).ok());
  REQUIRE(session.select("spherical").ok());
  REQUIRE(session.set("timeStep", encoded(timeStep)).ok());
  REQUIRE(session.set("maxIterations", encoded(maxIterations)).ok());
  REQUIRE(session.prepare().ok());
  return finish(session);
}

Status prepared(const TriangleMesh& mesh) {
  Session session;
  REQUIRE(session.load(mesh).ok());
  REQUIRE(session.select("spherical").ok());
  return session.prepare();
}

Vec3 centroid(const Points& positions, const Triangles& triangles) {
  const Scalars areas = barycentricAreas(positions, triangles);
  return positions.transpose() * areas / areas.sum();
}

/// Directions from the input's area centroid: the points of the unit sphere that a consumer reads off the result.
Points directions(const TriangleMesh& input, const Points& result) {
  return (result.rowwise() - centroid(input.positions, input.triangles).transpose()).rowwise().normalized();
}

/// Mean change of a corner's angle in degrees, weighted by the input's area.
double angleDistortion(const TriangleMesh& input, const Points& result) {
  const Scalars areas = faceAreas(input.positions, input.triangles);
  double sum = 0;
  for (Index f = 0; f < input.faceCount(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const auto angle = [&](const Points& points) {
        const Vec3 p = points.row(input.triangles(f, k)).transpose();
        const Vec3 a = points.row(input.triangles(f, (k + 1) % 3)).transpose() - p;
        const Vec3 b = points.row(input.triangles(f, (k + 2) % 3)).transpose() - p;
        return std::atan2(a.cross(b).norm(), a.dot(b));
      };
      sum += areas[f] * std::abs(angle(input.positions) - angle(result));
    }
  }
  return sum / (3 * areas.sum()) * 180 / EIGEN_PI;
}

/// A sphere with waves, stretched along x and bent.
TriangleMesh bumpyLong(int levels) {
  TriangleMesh mesh = sphere(levels);
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    const Vec3 p = mesh.positions.row(v).transpose();
    const Vec3 q = p * (1 + 0.2 * std::sin(4 * p.x()) * std::cos(3 * p.y() + 1));
    mesh.positions.row(v) << 2 * q.x(), q.y() + 0.4 * q.x() * q.x(), q.z();
  }
  return mesh;
}

}  // namespace

TEST_CASE("a sphere stays the sphere it is") {
  const TriangleMesh mesh = sphere(4);
  const Run result = flow(mesh);
  CHECK(result.outcome == Outcome::converged);
  CHECK(result.energies.size() <= 2);
  const Points moved = directions(mesh, result.positions);
  CHECK((moved - mesh.positions).rowwise().norm().maxCoeff() < 1e-3);
}

TEST_CASE("closed shapes become a round sphere, keep their angles and fold nowhere") {
  for (const TriangleMesh& mesh : {bent(sphere(4)), bumpyLong(4), longBox(24, 6)}) {
    const Run result = flow(mesh);
    CHECK(result.outcome == Outcome::converged);
    CHECK(result.energies.size() < 120);
    const Vec3 center = centroid(mesh.positions, mesh.triangles);
    const double radius = std::sqrt(faceAreas(mesh.positions, mesh.triangles).sum() / (4 * EIGEN_PI));
    const Scalars radii = (result.positions.rowwise() - center.transpose()).rowwise().norm();
    CHECK((radii.array() - radius).abs().maxCoeff() < 1e-12 * radius);
    CHECK(countFolded(mesh.triangles, result.positions, center) == 0);
    CHECK(result.energies.back() >= 1);
    CHECK(result.energies.back() < 1.02);
    CHECK(angleDistortion(mesh, result.positions) < 4.5);
    const Scalars weights = barycentricAreas(mesh.positions, mesh.triangles);
    CHECK((directions(mesh, result.positions).transpose() * weights).norm() < 1e-8 * weights.sum());
  }
}

TEST_CASE("finer meshes keep their angles better") {
  const double coarse = angleDistortion(bumpyLong(3), flow(bumpyLong(3)).positions);
  const double fine = angleDistortion(bumpyLong(5), flow(bumpyLong(5)).positions);
  CHECK(fine < 0.4 * coarse);
}

TEST_CASE("the sphere does not depend on the time step, on units or on place") {
  const TriangleMesh mesh = bumpyLong(4);
  const Points result = directions(mesh, flow(mesh).positions);
  const Points slower = directions(mesh, flow(mesh, 3e-4, 1000).positions);
  CHECK((slower - result).rowwise().norm().maxCoeff() < 0.02);

  TriangleMesh moved = mesh;
  moved.positions = (37 * mesh.positions).rowwise() + Eigen::RowVector3d(100, -20, 3);
  CHECK((directions(moved, flow(moved).positions) - result).rowwise().norm().maxCoeff() < 1e-5);
  moved.positions = mesh.positions * someRotation().transpose();
  CHECK((directions(moved, flow(moved).positions) * someRotation() - result).rowwise().norm().maxCoeff() < 1e-5);
}

TEST_CASE("turned inside out it flows just as well, and the same input gives the same bits") {
  TriangleMesh mesh = bumpyLong(3);
  const Run result = flow(mesh);
  CHECK(flow(mesh).positions == result.positions);
  mesh.triangles.col(0).swap(mesh.triangles.col(1));
  CHECK((flow(mesh).positions - result.positions).rowwise().norm().maxCoeff() < 1e-6);
}

TEST_CASE("natively and as wasm the flow takes the same steps to the same end") {
  const Run result = flow(bumpyLong(4));
  CHECK(std::abs(static_cast<int>(result.energies.size()) - 54) <= 1);
  CHECK(result.energies.back() == doctest::Approx(1.00193473).epsilon(1e-6));
  CHECK(result.positions.row(100).norm() == doctest::Approx(1.446803904).epsilon(1e-5));
}

TEST_CASE("the iteration limit leaves the surface on its way") {
  const TriangleMesh mesh = bumpyLong(4);
  CHECK(flow(mesh, 1e-3, 0).positions == mesh.positions);
  const Run result = flow(mesh, 1e-3, 5);
  CHECK(result.outcome == Outcome::iterationLimit);
  CHECK(result.energies.size() == 5);
  const double before = faceAreas(mesh.positions, mesh.triangles).sum();
  CHECK(faceAreas(result.positions, mesh.triangles).sum() == doctest::Approx(before));
  CHECK((centroid(result.positions, mesh.triangles) - centroid(mesh.positions, mesh.triangles)).norm() < 1e-12);
}

TEST_CASE("a vertex without a face stays where it is") {
  TriangleMesh mesh = bent(sphere(3));
  mesh.positions.conservativeResize(mesh.vertexCount() + 1, 3);
  mesh.positions.row(mesh.vertexCount() - 1) << 0.3, 1.2, -0.4;
  const Run result = flow(mesh);
  CHECK(result.outcome == Outcome::converged);
  CHECK(result.positions.bottomRows(1) == mesh.positions.bottomRows(1));
}

TEST_CASE("what cannot become a sphere is refused in words") {
  struct Refusal {
    const char* words;
    TriangleMesh mesh;
  };
  TriangleMesh doubled = sphere(2);
  doubled.triangles.conservativeResize(doubled.faceCount() + 1, 3);
  doubled.triangles.bottomRows(1) = doubled.triangles.topRows(1);
  TriangleMesh turned = sphere(2);
  std::swap(turned.triangles(9, 0), turned.triangles(9, 1));
  TriangleMesh touching = together(sphere(2), sphere(2), {2, 0, 0});
  for (Index c = 0; c < touching.triangles.size(); ++c) {
    if (touching.triangles.data()[c] == 66 + 1) touching.triangles.data()[c] = 0;  // where both have x = 1
  }
  TriangleMesh flat = sphere(2);
  flat.positions.row(flat.triangles(5, 1)) = flat.positions.row(flat.triangles(5, 0));
  TriangleMesh pricked = sphere(2);
  pricked.triangles.conservativeResize(pricked.faceCount() - 1, 3);
  for (const auto& [words, mesh] :
       {Refusal{"genus 1", torus(12)}, Refusal{"open along 36 edges", grid(10)}, Refusal{"open along 3 edges", pricked},
        Refusal{"2 separate parts", together(sphere(2), sphere(2), {3, 0, 0})}, Refusal{"three faces or more", doubled},
        Refusal{"disagree about the outside along 3 edges", turned},
        Refusal{"at vertex 0 separate sheets touch", touching}, Refusal{"have no area", flat},
        Refusal{"open along", moebiusStrip(24)}}) {
    const Status status = prepared(mesh);
    CHECK(status.code == Code::unsuitableMesh);
    CHECK_MESSAGE(status.message.find(words) != std::string::npos, status.message);
  }
}

TEST_CASE("what ends folded is refused, and the positions are those before") {
  TriangleMesh horseshoe = longBox(30, 3);
  for (Index v = 0; v < horseshoe.vertexCount(); ++v) {
    const Vec3 p = horseshoe.positions.row(v).transpose();
    const double turn = 0.5 * p.x(), radius = 2 + p.y();
    horseshoe.positions.row(v) << radius * std::sin(turn), radius * std::cos(turn), p.z();
  }
  Session session;
  REQUIRE(session.load(horseshoe).ok());
  REQUIRE(session.select("spherical").ok());
  REQUIRE(session.set("tolerance", encoded(1)).ok());  // stops at once, far from a sphere
  StepReport report;
  const Status status = session.step(report);
  CHECK(status.code == Code::numericalFailure);
  CHECK_MESSAGE(status.message.find(" faces over; ") != std::string::npos, status.message);
  Points positions(horseshoe.vertexCount(), 3);
  session.copyPositions(positions.data());
  CHECK(positions == horseshoe.positions);
}

TEST_CASE("meshes of few faces become balls, as finer ones of the same shape would") {
  for (const TriangleMesh& mesh : {blocks({{0, 0, 0}}, 1), blocks({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 1), longBox(8, 1),
                                   prism(5, 0), prism(16, 0), sphere(0)}) {
    const Run result = flow(mesh);
    CHECK(result.outcome == Outcome::converged);
    const Vec3 center = centroid(mesh.positions, mesh.triangles);
    const double radius = std::sqrt(faceAreas(mesh.positions, mesh.triangles).sum() / (4 * EIGEN_PI));
    const Scalars radii = (result.positions.rowwise() - center.transpose()).rowwise().norm();
    CHECK((radii.array() - radius).abs().maxCoeff() < 1e-9 * radius);
    CHECK(countFolded(mesh.triangles, result.positions, center) == 0);
  }
}

TEST_CASE("what the flow draws out to a needle is refused, at the iteration limit too") {
  TriangleMesh mast = prism(12, 0);
  mast.positions.col(2) *= 20;
  for (const int maxIterations : {1000, 15}) {
    Session session;
    REQUIRE(session.load(mast).ok());
    REQUIRE(session.select("spherical").ok());
    REQUIRE(session.set("maxIterations", encoded(maxIterations)).ok());
    StepReport report;
    Status status;
    while (status.ok() && report.outcome == Outcome::running) status = session.step(report);
    CHECK(status.code == Code::numericalFailure);
    CHECK_MESSAGE(status.message.find("needle; subdivide") != std::string::npos, status.message);
  }
}

TEST_CASE("a refusal is not forgotten, and its element is where the fault is") {
  Session session;
  TriangleMesh mesh = sphere(2);
  mesh.triangles.conservativeResize(mesh.faceCount() - 1, 3);
  REQUIRE(session.load(mesh).ok());
  REQUIRE(session.select("spherical").ok());
  CHECK(session.prepare().code == Code::unsuitableMesh);
  StepReport report;
  CHECK(session.step(report).code == Code::unsuitableMesh);
  const Index vertex = session.prepare().element.index;
  CHECK((sphere(2).triangles.bottomRows(1).array() == vertex).any());
}

TEST_CASE("a boost keeps the unit sphere and angles, and balancing finds its inverse") {
  const TriangleMesh mesh = sphere(4);
  const Scalars weights = barycentricAreas(mesh.positions, mesh.triangles);
  Points boosted = mesh.positions;
  for (Index v = 0; v < boosted.rows(); ++v) {
    boosted.row(v) = moebiusBoost(mesh.positions.row(v).transpose(), Vec3(0.5, -0.3, 0.6)).transpose();
  }
  CHECK((boosted.rowwise().norm().array() - 1).abs().maxCoeff() < 1e-12);
  CHECK(angleDistortion(mesh, boosted) < 4);  // of straight triangles; that of the arcs is zero
  balanceOnSphere(weights, boosted);
  CHECK((boosted.transpose() * weights).norm() < 1e-9 * weights.sum());
  // Boosts in different directions leave a trace of a rotation.
  CHECK((boosted - mesh.positions).rowwise().norm().maxCoeff() < 1e-3);
}

TEST_CASE("a small boost is no motion, anything else is") {
  const TriangleMesh mesh = sphere(4);
  const Scalars weights = barycentricAreas(mesh.positions, mesh.triangles);
  Points move = mesh.positions;
  for (Index v = 0; v < move.rows(); ++v) move.row(v) = moebiusBoost(move.row(v).transpose(), Vec3(1e-4, 2e-4, -3e-4));
  move -= mesh.positions;
  const double whole = move.rowwise().squaredNorm().dot(weights) / weights.sum();
  CHECK(meanSquareButBoost(weights, mesh.positions, move) < 1e-4 * whole);
  move.col(0).setZero();
  CHECK(meanSquareButBoost(weights, mesh.positions, move) > 0.05 * whole);
}
