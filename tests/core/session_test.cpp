#include "session/session.h"

#include <doctest/doctest.h>

#include <limits>
#include <numeric>

#include "methods/numbering.h"
#include "support/shapes.h"

using namespace whittle;
using namespace whittle::testing;

TEST_CASE("what cannot be done is refused by name and leaves the session usable") {
  Session session;
  CHECK(session.select("cubic").code == Code::noFaces);
  CHECK(session.prepare().code == Code::unknownMethod);
  REQUIRE(session.load(sphere(2)).ok());
  CHECK(session.select("spheric").code == Code::unknownMethod);
  REQUIRE(session.select("cubic").ok());

  CHECK(session.setNumber("lamda", 1).code == Code::badParameter);
  CHECK(session.setNumber("handles", 1).code == Code::badParameter);
  for (const double bad : {-0.1, 100.1, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    CHECK(session.setNumber("lambda", bad).code == Code::badParameter);
  }
  CHECK(session.setNumber("maxIterations", 2.5).code == Code::badParameter);

  const Points origin = Points::Zero(1, 3);
  CHECK(session.setHandles({{66}, origin}).code == Code::badHandles);
  CHECK(session.setHandles({{-1}, origin}).code == Code::badHandles);
  CHECK(session.setHandles({{3, 3}, Points::Zero(2, 3)}).code == Code::badHandles);
  CHECK(session.setHandles({{3}, Points::Constant(1, 3, std::numeric_limits<double>::infinity())}).code == Code::badHandles);

  REQUIRE(session.prepare().ok());
  StepReport report;
  CHECK(session.step(report).ok());
}

TEST_CASE("a refused mesh leaves none") {
  Session session;
  REQUIRE(session.load(sphere(2)).ok());
  CHECK(session.load({Points::Zero(3, 3), Triangles(0, 3)}).code == Code::noFaces);
  CHECK(session.select("cubic").code == Code::noFaces);
}

TEST_CASE("no iterations asked for, none done") {
  Session session;
  REQUIRE(session.load(sphere(2)).ok());
  REQUIRE(session.select("cubic").ok());
  REQUIRE(session.setNumber("maxIterations", 0).ok());
  REQUIRE(session.prepare().ok());
  StepReport report;
  REQUIRE(session.step(report).ok());
  CHECK(report.outcome == Outcome::iterationLimit);
  Points positions(66, 3);
  session.copyPositions(positions.data());
  CHECK(positions == sphere(2).positions);
}

TEST_CASE("all held: the handles are where they should be and nothing else happens") {
  const TriangleMesh mesh = grid(2);
  Session session;
  REQUIRE(session.load(mesh).ok());
  REQUIRE(session.select("arap").ok());
  Handles handles{{0, 1, 2, 3}, mesh.positions * 2};
  REQUIRE(session.setHandles(handles).ok());
  REQUIRE(session.prepare().ok());
  StepReport report;
  for (int step = 0; step < 3; ++step) REQUIRE(session.step(report).ok());
  CHECK(report.outcome == Outcome::converged);
  Points positions(4, 3);
  session.copyPositions(positions.data());
  CHECK((positions - handles.targets).norm() < 1e-12);
}

TEST_CASE("a numbering takes everything that belongs to vertices along, and gives the mesh back") {
  const TriangleMesh mesh = together(bent(sphere(2)), moebiusStrip(9), {3, 0, 0});
  const Index n = mesh.vertexCount();
  const Numbering numbering = Numbering::of(mesh);
  std::vector<int> seen(n, 0);
  for (Index place = 0; place < n; ++place) ++seen[numbering.vertexAt(place)];
  CHECK(std::all_of(seen.begin(), seen.end(), [](int times) { return times == 1; }));

  const TriangleMesh ordered = numbering.ordered(mesh);
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    for (int k = 0; k < 3; ++k) CHECK(numbering.vertexAt(ordered.triangles(f, k)) == mesh.triangles(f, k));
  }
  for (Index place = 0; place < n; ++place) CHECK(ordered.positions.row(place) == mesh.positions.row(numbering.vertexAt(place)));
  const TriangleMesh again = numbering.inFileOrder(ordered);
  CHECK(again.positions == mesh.positions);
  CHECK(again.triangles == mesh.triangles);

  const std::vector<ParameterInfo> infos = {{"number", ParameterKind::number, Stale::all},
                                            {"scalars", ParameterKind::scalars, Stale::all},
                                            {"rotations", ParameterKind::rotations, Stale::all},
                                            {"none", ParameterKind::scalars, Stale::all}};
  Settings settings = Settings::defaults(infos);
  settings.scalars[1].setLinSpaced(n, 0, n - 1);
  settings.scalars[2].setLinSpaced(4 * n, 0, 4 * n - 1);
  settings.handles = {{5, 70}, Points::Zero(2, 3)};
  const Settings moved = numbering.ordered(settings, infos);
  for (Index place = 0; place < n; ++place) {
    CHECK(moved.scalars[1][place] == numbering.vertexAt(place));
    for (int i = 0; i < 4; ++i) CHECK(moved.scalars[2][4 * place + i] == 4 * numbering.vertexAt(place) + i);
  }
  CHECK(moved.scalars[3].size() == 0);
  CHECK(numbering.vertexAt(moved.handles.vertices[0]) == 5);
  CHECK(numbering.vertexAt(moved.handles.vertices[1]) == 70);
}

TEST_CASE("vertices keep the file's numbers outside, and in what a refusal says") {
  TriangleMesh open = sphere(3);
  open.triangles.conservativeResize(open.faceCount() - 1, 3);
  const auto isOnHole = [&](Index v) { return (sphere(3).triangles.bottomRows(1).array() == v).any(); };
  Session session;
  REQUIRE(session.load(open).ok());
  REQUIRE(session.select("arap").ok());
  REQUIRE(session.setHandles({{7}, open.positions.row(7) * 1.5}).ok());
  REQUIRE(session.prepare().ok());
  StepReport report;
  REQUIRE(session.step(report).ok());
  Points positions(open.vertexCount(), 3);
  session.copyPositions(positions.data());
  CHECK((positions.row(7) - open.positions.row(7) * 1.5).norm() < 1e-12);

  REQUIRE(session.select("spherical").ok());
  const Status refused = session.prepare();
  CHECK(refused.code == Code::unsuitableMesh);
  CHECK(isOnHole(refused.element));
  CHECK(refused.message.find("vertex " + std::to_string(refused.element)) != std::string::npos);
}

TEST_CASE("the registry describes itself as JSON") {
  const std::string json = describeMethods();
  CHECK(json.front() == '[');
  CHECK(json.find("\"id\":\"cubic\"") != std::string::npos);
  CHECK(json.find("\"name\":\"lambda\",\"kind\":\"number\",\"invalidates\":\"weights\",\"default\":0.2") != std::string::npos);
}
