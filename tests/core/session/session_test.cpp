#include "session/session.h"

#include <doctest/doctest.h>

#include <limits>

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
