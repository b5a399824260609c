// Preparing in stages: what a caller sees between them, and what may happen there.
#include <doctest/doctest.h>

#include <set>
#include <string>
#include <vector>

#include "session/session.h"
#include "support/shapes.h"
#include "support/style_runs.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

/// Calls `prepareNext` until all is done; returns what it said it would do, one line for each call.
std::vector<std::string> prepareInStages(Session& session) {
  std::vector<std::string> stages;
  double share = 0, before = 0;
  while (share < 1) {
    stages.push_back(session.stage());
    REQUIRE(session.prepareNext(share).ok());
    CHECK(share >= before);
    CHECK(share <= 1);
    before = share;
  }
  CHECK(std::string(session.stage()) == "");
  return stages;
}

bool has(const std::vector<std::string>& stages, const char* stage) {
  return std::find(stages.begin(), stages.end(), stage) != stages.end();
}

void prepareUpTo(Session& session, const std::string& stage) {
  double share = 0;
  while (session.stage() != stage) REQUIRE(session.prepareNext(share).ok());
}

Points positionsOf(const Session& session, const TriangleMesh& mesh) {
  Points positions(mesh.vertexCount(), 3);
  session.copyPositions(positions.data());
  return positions;
}

/// Positions after some steps of a session that is prepared in one go.
Points stepped(Session& session, const TriangleMesh& mesh) {
  session.restart();
  REQUIRE(session.prepare().ok());
  StepReport report;
  for (int step = 0; step < 5; ++step) REQUIRE(session.step(report).ok());
  return positionsOf(session, mesh);
}

constexpr const char* kMethods[] = {"cubic",     "analogy", "polycube", "developable",
                                    "normalmap", "plastic", "arap",     "spherical"};

TextureSlopes slopesOn(const TriangleMesh& mesh) {
  TextureSlopes texture{CornerPairs(3 * mesh.faceCount(), 2), CornerPairs::Constant(3 * mesh.faceCount(), 2, 0.25f)};
  for (Index c = 0; c < texture.uvs.rows(); ++c) {
    texture.uvs.row(c) = mesh.positions.row(mesh.triangles.data()[c]).head<2>().cast<float>();
  }
  return texture;
}

/// Chooses a method and gives it what it cannot do without.
void choose(Session& session, const std::string& method, const TriangleMesh& mesh) {
  REQUIRE(session.select(method).ok());
  if (method == "analogy") REQUIRE(session.set("style", encoded(cubeStyle())).ok());
  if (method == "polycube") REQUIRE(session.set("directions", encoded(cubeStyle())).ok());
  if (method == "normalmap") REQUIRE(session.set("image", encoded(slopesOn(mesh))).ok());
}

}  // namespace

TEST_CASE("stages of every method lead where preparing in one go leads, each says what it does") {
  const TriangleMesh mesh = bent(sphere(3));
  for (const std::string method : kMethods) {
    INFO(method);
    Session staged, whole;
    REQUIRE(staged.load(mesh).ok());
    REQUIRE(whole.load(mesh).ok());
    CHECK(std::string(staged.stage()) == "");
    choose(staged, method, mesh);
    choose(whole, method, mesh);
    const std::vector<std::string> stages = prepareInStages(staged);
    CHECK(stages.size() > 2);
    CHECK(has(stages, "ordering the vertices"));
    CHECK(has(stages, "measuring the mesh"));
    CHECK(!has(stages, ""));
    CHECK(stepped(staged, mesh) == stepped(whole, mesh));
  }
}

TEST_CASE("only what is stale is done again") {
  const TriangleMesh mesh = bent(sphere(3));
  Session session;
  REQUIRE(session.load(mesh).ok());
  REQUIRE(session.select("cubic").ok());
  CHECK(has(prepareInStages(session), "ordering the vertices"));
  CHECK(prepareInStages(session) == std::vector<std::string>{""});  // a run from the present positions
  REQUIRE(session.set("tolerance", encoded(0.1)).ok());
  CHECK(prepareInStages(session) == std::vector<std::string>{"taking the settings"});
  REQUIRE(session.set("lambda", encoded(0.1)).ok());
  CHECK(!has(prepareInStages(session), "factoring the system"));
  REQUIRE(session.set("handles", encoded(Handles{{0}, Points::Zero(1, 3)})).ok());
  const std::vector<std::string> stages = prepareInStages(session);
  CHECK(has(stages, "factoring the system"));
  CHECK(!has(stages, "measuring the mesh"));
  REQUIRE(session.select("arap").ok());
  CHECK(!has(prepareInStages(session), "ordering the vertices"));
}

TEST_CASE("a value that is set between stages is the one that counts, and does again only what has read the old one") {
  const TriangleMesh mesh = bent(sphere(3));
  const Points held = mesh.positions.row(7) * 1.5;
  for (const char* stage :
       {"measuring the mesh", "factoring the system", "preparing the local step", "taking the settings"}) {
    INFO(stage);
    Session session, fresh;
    REQUIRE(session.load(mesh).ok());
    REQUIRE(session.select("cubic").ok());
    prepareUpTo(session, stage);
    REQUIRE(session.set("lambda", encoded(0.9)).ok());
    CHECK((std::string(session.stage()) == stage || std::string(stage) == "taking the settings"));
    prepareUpTo(session, "taking the settings");
    REQUIRE(session.set("handles", encoded(Handles{{7}, held})).ok());
    const std::vector<std::string> stages = prepareInStages(session);
    CHECK(has(stages, "factoring the system"));
    CHECK(!has(stages, "measuring the mesh"));

    REQUIRE(fresh.load(mesh).ok());
    REQUIRE(fresh.select("cubic").ok());
    REQUIRE(fresh.set("lambda", encoded(0.9)).ok());
    REQUIRE(fresh.set("handles", encoded(Handles{{7}, held})).ok());
    CHECK(stepped(session, mesh) == stepped(fresh, mesh));
  }
}

TEST_CASE("a preparation that is left half done harms nothing") {
  const TriangleMesh mesh = bent(sphere(3));
  Session session, fresh;
  REQUIRE(session.load(mesh).ok());
  REQUIRE(session.select("cubic").ok());
  for (const char* stage : {"ordering the vertices", "collecting the edges", "factoring the system"}) {
    prepareUpTo(session, stage);
    CHECK(positionsOf(session, mesh) == mesh.positions);
    REQUIRE(session.select("arap").ok());
    prepareUpTo(session, stage == std::string("ordering the vertices") ? stage : "factoring the system");
    REQUIRE(session.select("cubic").ok());
  }
  REQUIRE(fresh.load(mesh).ok());
  REQUIRE(fresh.select("cubic").ok());
  CHECK(stepped(session, mesh) == stepped(fresh, mesh));

  // A step by a caller that does not wait for the end does what is left.
  REQUIRE(session.set("lambda", encoded(0.7)).ok());
  double share = 0;
  REQUIRE(session.prepareNext(share).ok());
  StepReport report;
  CHECK(session.step(report).ok());
}

TEST_CASE("values that do not go together are refused before anything is computed, between stages too") {
  const TriangleMesh mesh = bent(sphere(2));
  Session session;
  REQUIRE(session.load(mesh).ok());
  REQUIRE(session.select("analogy").ok());
  double share = 1;
  CHECK(session.prepareNext(share).code == Code::badParameter);
  CHECK(share == 0);
  REQUIRE(session.set("style", encoded(cubeStyle())).ok());
  prepareUpTo(session, "factoring the system");
  REQUIRE(session.set("style", RawValue{}).ok());
  CHECK(session.prepareNext(share).code == Code::badParameter);
  CHECK(session.prepareNext(share).code == Code::badParameter);
  REQUIRE(session.set("style", encoded(cubeStyle())).ok());
  CHECK(!has(prepareInStages(session), "measuring the mesh"));
}

TEST_CASE("a field of scales shows what acap does to sizes") {
  const TriangleMesh mesh = bent(sphere(3));
  Session session;
  REQUIRE(session.load(mesh).ok());
  REQUIRE(session.select("arap").ok());
  REQUIRE(session.set("regularizer", encoded("acap")).ok());
  // All of the mesh but one vertex is held at twice its size.
  Handles handles{{}, mesh.positions.bottomRows(mesh.vertexCount() - 1) * 2};
  for (Index v = 1; v < mesh.vertexCount(); ++v) handles.vertices.push_back(v);
  REQUIRE(session.set("handles", encoded(handles)).ok());
  CHECK(session.fields().empty());
  REQUIRE(session.prepare().ok());
  REQUIRE(session.fields().size() == 1);
  CHECK(describeFields(session.fields()) == R"([{"name":"size","label":"Change of size","per":"vertex","unit":"×"}])");
  Scalars size(mesh.vertexCount());
  REQUIRE(session.copyField("size", size.data()).ok());
  CHECK(size == Scalars::Ones(mesh.vertexCount()));
  StepReport report;
  for (int step = 0; step < 10; ++step) REQUIRE(session.step(report).ok());
  REQUIRE(session.copyField("size", size.data()).ok());
  CHECK((size - 2 * Scalars::Ones(mesh.vertexCount())).cwiseAbs().maxCoeff() < 1e-3);
  CHECK(session.copyField("weight", size.data()).code == Code::badParameter);

  // Vertex by vertex in the order in which they were loaded: one end of the mesh is held as it was, the other at half
  // its size.
  Handles halves{handles.vertices, mesh.positions.bottomRows(mesh.vertexCount() - 1)};
  for (Index h = 0; h < halves.targets.rows(); ++h) {
    if (halves.targets(h, 0) > 0) halves.targets.row(h) *= 0.5;
  }
  REQUIRE(session.set("handles", encoded(halves)).ok());
  session.restart();
  REQUIRE(session.prepare().ok());
  for (int step = 0; step < 10; ++step) REQUIRE(session.step(report).ok());
  REQUIRE(session.copyField("size", size.data()).ok());
  for (Index v = 1; v < mesh.vertexCount(); ++v) {
    if (std::abs(mesh.positions(v, 0)) > 0.4)
      CHECK(size[v] == doctest::Approx(mesh.positions(v, 0) > 0 ? 0.5 : 1).epsilon(0.02));
  }
}

TEST_CASE("what is to be prepared goes by the values that were set, asked for or not") {
  const TriangleMesh mesh = sphere(4);
  const Index last = mesh.vertexCount() - 1;
  Points targets(2, 3);
  targets << mesh.positions.row(0), 1.5 * mesh.positions.row(last);
  for (const char* variant : {"slippage", "alup", "poisson", "arap", "conformal"}) {
    CAPTURE(variant);
    const auto run = [&](bool isAsked) {
      Session session;
      REQUIRE(session.load(mesh).ok());
      REQUIRE(session.select("reshape").ok());
      REQUIRE(session.set("variant", RawValue{.name = variant}).ok());
      REQUIRE(session.set("handles", encoded(Handles{{0, last}, targets})).ok());
      if (isAsked) CHECK(std::string(session.stage()) != "");
      return stepped(session, mesh);
    };
    CHECK(run(true) == run(false));
  }
}
