// Vertices held on planes, with every local/global method.
#include <doctest/doctest.h>

#include <cmath>

#include "geometry/surface.h"
#include "session/session.h"
#include "support/allocations.h"
#include "support/runs.h"
#include "support/shapes.h"
#include "support/style_runs.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

struct Setup {
  std::string method = "cubic";
  double lambda = 0.4;
  Planes planes = {};
  Handles handles = {};
  int maxIterations = 60;
};

void configure(Session& session, const Setup& setup) {
  REQUIRE(session.select(setup.method).ok());
  if (setup.method != "arap") REQUIRE(session.set("lambda", encoded(setup.lambda)).ok());
  if (setup.method == "analogy") REQUIRE(session.set("style", encoded(octahedronStyle())).ok());
  REQUIRE(session.set("maxIterations", encoded(setup.maxIterations)).ok());
  REQUIRE(session.set("handles", encoded(setup.handles)).ok());
  REQUIRE(session.set("planes", encoded(setup.planes)).ok());
}

/// Vertices on the side of a mesh towards a direction.
std::vector<Index> side(const TriangleMesh& mesh, const Vec3& towards, double beyond) {
  std::vector<Index> vertices;
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    if (mesh.positions.row(v).dot(towards.transpose()) > beyond) vertices.push_back(v);
  }
  return vertices;
}

double diagonal(const TriangleMesh& mesh) {
  return (mesh.positions.colwise().maxCoeff() - mesh.positions.colwise().minCoeff()).norm();
}

/// The farthest that a vertex is from a plane that it is to be on.
double farthestOff(const Planes& planes, const Points& positions) {
  double farthest = 0;
  for (const Plane& plane : planes) {
    for (const Index v : plane.vertices) {
      const double off = plane.normal.dot(positions.row(v).transpose()) - plane.offset;
      farthest = std::max(farthest, std::abs(off) / plane.normal.norm());
    }
  }
  return farthest;
}

/// Runs to the end and looks at every shape on the way.
Run watched(const TriangleMesh& mesh, const Setup& setup) {
  Session session;
  REQUIRE(session.load(mesh).ok());
  configure(session, setup);
  REQUIRE(session.prepare().ok());
  Run run;
  run.positions.resize(mesh.vertexCount(), 3);
  while (run.outcome == Outcome::running) {
    session.copyPositions(run.positions.data());
    REQUIRE(farthestOff(setup.planes, run.positions) <= 1e-9 * diagonal(mesh));
    StepReport report;
    const long before = allocationCount();
    REQUIRE(session.step(report).ok());
    REQUIRE(allocationCount() == before);
    if (report.outcome != Outcome::iterationLimit) run.energies.push_back(report.energy);
    run.outcome = report.outcome;
  }
  session.copyPositions(run.positions.data());
  REQUIRE(farthestOff(setup.planes, run.positions) <= 1e-9 * diagonal(mesh));
  return run;
}

Points solved(const TriangleMesh& mesh, const Setup& setup) { return watched(mesh, setup).positions; }

void requireMonotone(const std::vector<double>& energies) {
  for (std::size_t k = 1; k < energies.size(); ++k)
    REQUIRE(energies[k] <= energies[k - 1] + 3e-8 * (std::abs(energies[0]) + 1));
}

double largestMove(const Points& a, const Points& b) { return (a - b).rowwise().norm().maxCoeff(); }

Vec3 centroid(const Points& positions, const TriangleMesh& mesh) {
  const Scalars areas = barycentricAreas(mesh.positions, mesh.triangles);
  return (areas.asDiagonal() * positions).colwise().sum().transpose() / areas.sum();
}

}  // namespace

TEST_CASE("planes hold exactly in every iteration, whatever their normals, while the energy falls") {
  const TriangleMesh mesh = bent(sphere(3));
  const Vec3 slanted(1, -2, 0.5), other(0.3, 4, 1);
  const std::vector<Planes> all = {
      {{side(mesh, Vec3::UnitZ(), 0.6), Vec3::UnitZ(), 0.5}},
      {{side(mesh, slanted, 1), slanted, 0.7}},
      {{side(mesh, slanted, 1), slanted, 0.7}, {side(mesh, other, 1), other, 2}},
      {{{3, 4, 70}, slanted, 0.7}, {{4, 70}, other, 0.5}, {{70}, Vec3::UnitX(), 0.1}},  // a plane, a line, a point
  };
  for (const char* method : {"cubic", "arap", "analogy", "developable"}) {
    for (const Planes& planes : all) {
      CAPTURE(method);
      CAPTURE(planes.size());
      const Run run = watched(mesh, {method, 0.4, planes});
      CHECK(run.energies.size() > 3);
      if (std::string(method) != "developable") requireMonotone(run.energies);
      CHECK(run.positions.allFinite());
    }
  }
}

TEST_CASE("planes hold far from the origin, in any unit and order") {
  const TriangleMesh mesh = bent(sphere(3));
  const Vec3 normal(1, -2, 0.5);
  const Setup setup{"cubic", 0.4, {{side(mesh, normal, 1), normal, 0.7}}, {}, 30};
  const Points plain = solved(mesh, setup);
  for (const double scale : {1e-3, 300.0}) {
    const Eigen::RowVector3d shift(20 * scale, -3 * scale, scale);
    const TriangleMesh moved{(scale * mesh.positions).rowwise() + shift, mesh.triangles};
    Setup there = setup;
    there.planes[0].offset = scale * setup.planes[0].offset + normal.dot(shift.transpose());
    CHECK(largestMove((solved(moved, there).rowwise() - shift) / scale, plain) < 2e-6);
  }
  Setup shuffledSetup = setup;
  for (Index& v : shuffledSetup.planes[0].vertices) v = shuffledPlace(v, mesh.vertexCount());
  const Points other = solved(shuffled(mesh), shuffledSetup);
  for (Index v = 0; v < mesh.vertexCount(); ++v)
    REQUIRE((plain.row(v) - other.row(shuffledPlace(v, mesh.vertexCount()))).norm() < 4e-6);
}

TEST_CASE("no planes, or planes of no vertices, give the very bits; those through what lies on them leave it at rest") {
  const TriangleMesh mesh = bent(sphere(3));
  CHECK(solved(mesh, {"cubic", 0.4, {{{}, Vec3::UnitX(), 3}}}) == solved(mesh, {}));
  const TriangleMesh sheet = grid(9);
  std::vector<Index> every(sheet.vertexCount());
  for (Index v = 0; v < sheet.vertexCount(); ++v) every[v] = v;
  CHECK(solved(sheet, {"cubic", 0, {{every, Vec3(0, 0, -3), 0}}}) == sheet.positions);
  const Vec3 point = mesh.positions.row(9).transpose(), normal(1, 2, 3);
  CHECK(solved(mesh, {"arap", 0, {{{9}, normal, normal.dot(point)}}}) == mesh.positions);
}

TEST_CASE("along its planes a part keeps its centre, across them it goes with them") {
  const TriangleMesh mesh = bent(sphere(3));
  const Vec3 middle = centroid(mesh.positions, mesh);
  const Vec3 n = Vec3(1, -2, 0.5).normalized(), m = Vec3(2, 1, 1).normalized();
  const std::vector<Index> low = side(mesh, n, 0.7);
  double mean = 0;
  for (const Index v : low) mean += mesh.positions.row(v).dot(n.transpose()) / static_cast<double>(low.size());
  for (const double away : {0.0, 2.0}) {
    const Points one = solved(mesh, {"cubic", 0.3, {{low, n, mean + away}}, {}, 300});
    const Vec3 move = centroid(one, mesh) - middle;
    CHECK((move - n.dot(move) * n).norm() < 1e-8);
    CHECK(std::abs(n.dot(move) - away) < 0.25);
  }
  const Points two = solved(mesh, {"cubic", 0.3, {{low, n, mean}, {side(mesh, m, 0.8), m, 0.9}}});
  CHECK(std::abs(n.cross(m).normalized().dot(centroid(two, mesh) - middle)) < 1e-8);
}

TEST_CASE("parts on planes of their own do not feel each other, and those that are tied keep their centre as one") {
  const TriangleMesh a = bent(sphere(3)), b = bent(grid(9));
  const TriangleMesh both = together(a, b, {10, -4, 2});
  const Vec3 n(0.3, 1, -0.2);
  const Planes planes{{side(a, n, 0.7), n, 0.6}};
  const Points apart = solved(both, {"cubic", 0.4, planes});
  CHECK((centroid(apart.bottomRows(b.vertexCount()), b) - centroid(b.positions, b) - Vec3(10, -4, 2)).norm() < 1e-8);
  const Points touching = solved(together(a, a, {1.9, 0, 0}), {"cubic", 0.4, {{side(a, n, 0.7), n, 5}}});
  const Vec3 way = centroid(touching.bottomRows(a.vertexCount()), a) - centroid(a.positions, a) - Vec3(1.9, 0, 0);
  CHECK(n.normalized().dot(way) > 3);  // the other went along
}

TEST_CASE("planes that are nearly parallel hold, however they stand to each other") {
  const TriangleMesh mesh = bent(sphere(4));
  for (const double tilt : {1e-6, 1e-3, 0.01, 0.019, 0.021, 0.05, 0.3}) {
    CAPTURE(tilt);
    const Vec3 n(0.2, 0.1, 1), m = n + Vec3(tilt, 0, 0);
    const Run run = watched(mesh, {"cubic", 0.4, {{side(mesh, n, 0.8), n, 0.9}, {side(mesh, -n, 0.8), m, -0.9}}});
    requireMonotone(run.energies);
    // What is more than a wedge of a degree slides to where it fits.
    CHECK(largestMove(run.positions, mesh.positions) < (tilt < 0.02 ? 0.8 : 10));
  }
}

TEST_CASE("a plane that is shifted is followed without a new system, and leads where it leads from the start") {
  const TriangleMesh mesh = bent(sphere(3));
  const Vec3 n(1, -2, 0.5);
  Setup setup{"cubic", 0.4, {{side(mesh, n, 1), n, 0.7}}, {}, 40};
  Session session;
  REQUIRE(session.load(mesh).ok());
  configure(session, setup);
  REQUIRE(session.prepare().ok());
  StepReport report;
  for (int step = 0; step < 5; ++step) REQUIRE(session.step(report).ok());
  setup.planes[0].offset = 1.1;
  REQUIRE(session.set("planes", encoded(setup.planes)).ok());
  CHECK(std::string(session.stage()) == "taking the settings");
  session.restart();
  REQUIRE(session.prepare().ok());
  CHECK(finish(session).positions == solved(mesh, setup));
}

TEST_CASE("a handle goes before the plane that it lies on, and one beside it is refused") {
  const TriangleMesh mesh = bent(sphere(3));
  const Vec3 n = Vec3(1, -2, 0.5).normalized();
  Setup setup{"arap", 0, {{{5, 6, 7, 40}, n, 0.7}}, {{6}, Points(1, 3)}, 30};
  const Vec3 place = 0.7 * n + 0.2 * n.unitOrthogonal();
  setup.handles.targets.row(0) = place.transpose();
  const Points held = solved(mesh, setup);
  CHECK((held.row(6).transpose() - place).norm() < 1e-12);
  setup.handles.targets.row(0) += 1e-6 * n.transpose();
  Session session;
  std::vector<Index> numbers(mesh.vertexCount());
  for (Index v = 0; v < mesh.vertexCount(); ++v) numbers[v] = 2 * v + 1000;
  REQUIRE(session.load(mesh, numbers).ok());
  configure(session, setup);
  const Status status = session.prepare();
  CHECK(status.code == Code::badPlanes);
  CHECK(status.element.index == 1012);
  CHECK(status.message.find("vertex 1012 is on plane 0") == 0);
  const Planes apart{{{8, 9}, n, 0.7}, {{3, 9}, -2 * n, 0.7}};
  const Status refused = session.set("planes", encoded(apart));
  CHECK(refused.code == Code::badPlanes);
  CHECK(refused.message.find("vertex 1018 is on planes") == 0);
}
