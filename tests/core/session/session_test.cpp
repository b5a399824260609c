#include "session/session.h"

#include <doctest/doctest.h>

#include <cmath>
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

  CHECK(session.set("lamda", encoded(1)).code == Code::badParameter);
  CHECK(session.set("handles", encoded(1)).code == Code::badParameter);
  for (const double bad :
       {-0.1, 100.1, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    CHECK(session.set("lambda", encoded(bad)).code == Code::badParameter);
  }
  CHECK(session.set("maxIterations", encoded(2.5)).code == Code::badParameter);

  const Points origin = Points::Zero(1, 3);
  CHECK(session.set("handles", encoded(Handles{{66}, origin})).code == Code::badHandles);
  CHECK(session.set("handles", encoded(Handles{{-1}, origin})).code == Code::badHandles);
  CHECK(session.set("handles", encoded(Handles{{3, 3}, Points::Zero(2, 3)})).code == Code::badHandles);
  CHECK(session.set("handles", encoded(Handles{{3}, Points::Constant(1, 3, std::numeric_limits<double>::infinity())}))
            .code == Code::badHandles);

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
  REQUIRE(session.set("maxIterations", encoded(0)).ok());
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
  REQUIRE(session.set("handles", encoded(handles)).ok());
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
  REQUIRE(session.set("handles", encoded(Handles{{7}, open.positions.row(7) * 1.5})).ok());
  REQUIRE(session.prepare().ok());
  StepReport report;
  REQUIRE(session.step(report).ok());
  Points positions(open.vertexCount(), 3);
  session.copyPositions(positions.data());
  CHECK((positions.row(7) - open.positions.row(7) * 1.5).norm() < 1e-12);

  REQUIRE(session.select("spherical").ok());
  const Status refused = session.prepare();
  CHECK(refused.code == Code::unsuitableMesh);
  CHECK(isOnHole(refused.element.index));
  CHECK(refused.message.find("vertex " + std::to_string(refused.element.index)) != std::string::npos);
}

TEST_CASE("failures speak of the numbers that the file has for its vertices") {
  const TriangleMesh mesh = sphere(2);
  std::vector<Index> source;
  for (Index v = 0; v < mesh.vertexCount(); ++v) source.push_back(1000 - v);
  const auto speaksOf = [](const Status& status, const char* element, Index number) {
    INFO(status.message);
    CHECK(status.element.index == number);
    CHECK(status.message.find(element + (" " + std::to_string(number))) != std::string::npos);
    CHECK(status.message.find("{}") == std::string::npos);
  };
  Session session;
  REQUIRE(session.load(mesh, source).ok());
  REQUIRE(session.select("cubic").ok());
  Scalars lambdas = Scalars::Ones(66);
  lambdas[7] = -1;
  speaksOf(session.set("lambdaPerVertex", encoded(lambdas)), "vertex", 993);
  speaksOf(session.set("handles", encoded(Handles{{4, 4}, Points::Zero(2, 3)})), "vertex", 996);
  speaksOf(session.set("polyhedron", encoded(Scalars::Zero(3))), "row", 0);  // not an element of the mesh

  TriangleMesh broken = mesh;
  broken.positions(5, 1) = std::numeric_limits<double>::quiet_NaN();
  speaksOf(session.load(broken, source), "vertex", 995);
  broken = mesh;
  broken.triangles(9, 2) = 66;
  speaksOf(session.load(broken, source), "face", 9);

  TriangleMesh open = mesh;
  open.triangles.conservativeResize(open.faceCount() - 1, 3);
  REQUIRE(session.load(open, source).ok());
  for (const char* method : {"arap", "spherical"}) {  // before the vertices are ordered, and after
    REQUIRE(session.select("spherical").ok());
    const Status refused = session.prepare();
    speaksOf(refused, "vertex", refused.element.index);
    CHECK((mesh.triangles.bottomRows(1).array() == 1000 - refused.element.index).any());
    REQUIRE(session.select(method).ok());
    CHECK(session.prepare().ok() == (std::string(method) == "arap"));
  }
}

TEST_CASE("warnings say what will not do anything") {
  Session session;
  CHECK(session.warnings().empty());
  REQUIRE(session.load(sphere(2)).ok());
  REQUIRE(session.select("arap").ok());
  REQUIRE(session.warnings().size() == 1);
  CHECK(session.warnings()[0].find("handles") != std::string::npos);
  REQUIRE(session.set("handles", encoded(Handles{{0}, Points::Zero(1, 3)})).ok());
  CHECK(session.warnings().empty());

  REQUIRE(session.select("cubic").ok());
  CHECK(session.warnings().empty());
  REQUIRE(session.set("lambda", encoded(0)).ok());
  CHECK(session.warnings().size() == 1);
  REQUIRE(session.set("lambdaPerVertex", encoded(Scalars::Ones(66))).ok());
  CHECK(session.warnings().empty());
}

TEST_CASE("outcomes have names") {
  CHECK(std::string(outcomeName(Outcome::running)) == "running");
  CHECK(std::string(outcomeName(Outcome::converged)) == "converged");
  CHECK(std::string(outcomeName(Outcome::iterationLimit)) == "iteration-limit");
  CHECK(std::string(outcomeName(Outcome::stalled)) == "stalled");
}

TEST_CASE("the registry describes itself as JSON") {
  const std::string json = describeMethods();
  CHECK(json.front() == '[');
  CHECK(json.find("\"id\":\"cubic\"") != std::string::npos);
  CHECK(json.find("\"name\":\"lambda\",\"kind\":\"number\",\"invalidates\":\"weights\",\"default\":0.2") !=
        std::string::npos);
}

TEST_CASE("a stray vertex or part far away changes nothing, and stays where it is") {
  const auto carved = [](const TriangleMesh& mesh) {
    Session session;
    REQUIRE(session.load(mesh).ok());
    REQUIRE(session.select("cubic").ok());
    REQUIRE(session.prepare().ok());
    for (StepReport report; report.outcome == Outcome::running;) REQUIRE(session.step(report).ok());
    Points positions(mesh.vertexCount(), 3);
    session.copyPositions(positions.data());
    return positions;
  };
  const TriangleMesh body = animal(3);
  const Points alone = carved(body);
  TriangleMesh speck = sphere(0);
  speck.positions *= 1e-2;
  const Points beside = carved(together(body, speck, Vec3(1e4, -1e4, 0)));
  CHECK((beside.topRows(body.vertexCount()) - alone).cwiseAbs().maxCoeff() < 1e-4);

  TriangleMesh strays = body;
  strays.positions.conservativeResize(body.vertexCount() + 2, 3);
  strays.positions.row(body.vertexCount()) << 1e6, 2e6, std::numeric_limits<double>::quiet_NaN();
  strays.positions.row(body.vertexCount() + 1) << 1e5, -3, 7;
  const Points left = carved(strays);
  CHECK((left.topRows(body.vertexCount()) - alone).cwiseAbs().maxCoeff() < 1e-5);
  CHECK(left.bottomRows<1>() == strays.positions.bottomRows<1>());
  CHECK(left.row(body.vertexCount()).head<2>() == strays.positions.row(body.vertexCount()).head<2>());
  CHECK(std::isnan(left(body.vertexCount(), 2)));
}

TEST_CASE("refusals name faces by the number that the file has") {
  TriangleMesh mesh = sphere(1);
  mesh.triangles(4, 1) = 99;
  std::vector<Index> faces(mesh.faceCount());
  for (Index f = 0; f < mesh.faceCount(); ++f) faces[f] = 10 * f;
  Session session;
  const Status status = session.load(mesh, {}, faces);
  CHECK(status.element.index == 40);
  CHECK(status.message.find("face 40") != std::string::npos);
}
