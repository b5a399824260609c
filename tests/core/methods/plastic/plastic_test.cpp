// The method through a session: what landmarks come to, and what cannot be met is said.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "session/session.h"
#include "support/runs.h"
#include "support/shapes.h"
#include "support/surface_measures.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

double diagonal(const TriangleMesh& mesh) {
  return (mesh.positions.colwise().maxCoeff() - mesh.positions.colwise().minCoeff()).norm();
}

/// A mesh with landmarks.
struct Gesture {
  TriangleMesh mesh;
  Handles landmarks = {};

  void move(Index vertex, const Vec3& target) {
    landmarks.vertices.push_back(vertex);
    landmarks.targets.conservativeResize(landmarks.targets.rows() + 1, 3);
    landmarks.targets.bottomRows(1) = target.transpose();
  }
  void hold(Index vertex) { move(vertex, mesh.positions.row(vertex).transpose()); }
  Vec3 at(Index vertex) const { return mesh.positions.row(vertex).transpose(); }
};

struct Solved : Run {
  std::vector<std::string> warnings;
};

Solved solve(const Gesture& gesture, double radius = 0.15) {
  Session session;
  REQUIRE(session.load(gesture.mesh).ok());
  REQUIRE(session.select("plastic").ok());
  REQUIRE(session.set("landmarks", encoded(gesture.landmarks)).ok());
  REQUIRE(session.set("radius", encoded(radius)).ok());
  REQUIRE(session.prepare().ok());
  Solved solved{finish(session), {}};
  solved.warnings = session.warnings();
  CHECK(solved.positions.allFinite());
  return solved;
}

/// The mean distance of landmarks from their targets, in a shape whose diagonal is 100.
double meanError(const Gesture& gesture, const Points& positions) {
  double sum = 0;
  for (std::size_t l = 0; l < gesture.landmarks.vertices.size(); ++l)
    sum += (positions.row(gesture.landmarks.vertices[l]) - gesture.landmarks.targets.row(static_cast<Index>(l))).norm();
  return 100 / diagonal(gesture.mesh) * sum / static_cast<double>(gesture.landmarks.vertices.size());
}

/// The body of an animal whose ear is pulled up and aside, its feet held.
Gesture ear(int levels = 3) {
  Gesture gesture{animal(levels)};
  Index highest = 0;
  const double low = gesture.mesh.positions.col(1).minCoeff(), high = gesture.mesh.positions.col(1).maxCoeff(&highest);
  for (Index v = 0; v < gesture.mesh.vertexCount(); ++v) {
    if (gesture.mesh.positions(v, 1) < low + 0.15 * (high - low)) gesture.hold(v);
  }
  gesture.move(highest, gesture.at(highest) + (high - low) * Vec3(0.3, 0.4, 0));
  return gesture;
}

}  // namespace

TEST_CASE("without landmarks, or with none that moves, the mesh stays what it is to the bit") {
  Gesture gesture{animal(2)};
  const Solved without = solve(gesture);
  CHECK(without.positions == gesture.mesh.positions);
  CHECK(without.outcome == Outcome::converged);
  REQUIRE(without.warnings.size() == 1);
  CHECK(without.warnings[0].find("no landmarks") != std::string::npos);
  for (Index v = 0; v < 20; ++v) gesture.hold(v);
  CHECK(solve(gesture).positions == gesture.mesh.positions);
}

TEST_CASE("two landmarks that ask for half as much again grow all of a shape by exactly that (Fig. 17)") {
  Gesture gesture{animal(3)};
  Index lowest, highest;
  gesture.mesh.positions.col(1).minCoeff(&lowest);
  gesture.mesh.positions.col(1).maxCoeff(&highest);
  const Vec3 foot = gesture.at(lowest);
  gesture.hold(lowest);
  gesture.move(highest, foot + 1.5 * (gesture.at(highest) - foot));
  const Solved solved = solve(gesture, 1);
  const Points grown = (1.5 * (gesture.mesh.positions.rowwise() - foot.transpose())).rowwise() + foot.transpose();
  const double off = std::sqrt((solved.positions - grown).rowwise().squaredNorm().mean());
  CHECK(100 / diagonal(gesture.mesh) * off < 0.02);
  CHECK(solved.outcome == Outcome::converged);
}

TEST_CASE("a hard edit is met in a few steps, its held vertices to the bit, and nothing folds") {
  const Gesture gesture = ear();
  const Solved solved = solve(gesture);
  CHECK(solved.outcome == Outcome::converged);
  CHECK(solved.energies.size() <= 8);
  CHECK(meanError(gesture, solved.positions) < 0.02);
  CHECK(foldCount(solved.positions, gesture.mesh.triangles) == 0);
  for (std::size_t l = 0; l + 1 < gesture.landmarks.vertices.size(); ++l) {
    const Index v = gesture.landmarks.vertices[l];
    CHECK(solved.positions.row(v) == gesture.mesh.positions.row(v));
  }
  CHECK(solved.warnings.empty());
}

TEST_CASE("a turned, grown and moved input gives a turned, grown and moved answer") {
  const Gesture gesture = ear();
  const Mat3 turn = someRotation();
  const Vec3 shift(30, -20, 50);
  Gesture other{{(7 * gesture.mesh.positions * turn.transpose()).rowwise() + shift.transpose(), gesture.mesh.triangles},
                gesture.landmarks};
  other.landmarks.targets = (7 * gesture.landmarks.targets * turn.transpose()).rowwise() + shift.transpose();
  const Points expected = (7 * solve(gesture).positions * turn.transpose()).rowwise() + shift.transpose();
  CHECK((solve(other).positions - expected).rowwise().norm().maxCoeff() < 1e-4 * diagonal(other.mesh));
}

TEST_CASE("the same landmarks give the same bits, whatever was solved before") {
  const Gesture gesture = ear();
  const Points once = solve(gesture).positions;
  CHECK(solve(gesture).positions == once);
  Session session;
  REQUIRE(session.load(gesture.mesh).ok());
  REQUIRE(session.select("plastic").ok());
  Handles nearer = gesture.landmarks;
  nearer.targets.bottomRows(1) -= Vec3(0.2, 0.1, 0.3).transpose();
  for (const Handles& landmarks : {nearer, gesture.landmarks}) {
    session.restart();
    REQUIRE(session.set("landmarks", encoded(landmarks)).ok());
    REQUIRE(session.prepare().ok());
    const Run run = finish(session);
    if (&landmarks != &nearer && landmarks.targets == gesture.landmarks.targets) CHECK(run.positions == once);
  }
}

TEST_CASE("parts without a moved landmark stay, and one with a single one moves as it is") {
  const TriangleMesh ball = animal(2);
  Gesture gesture{together(ball, ball, Vec3(6, 0, 0))};
  const Vec3 shift(0.5, 1, -0.3);
  gesture.move(5, gesture.at(5) + shift);
  const Solved solved = solve(gesture);
  const Index first = ball.vertexCount();
  CHECK(solved.positions.bottomRows(first) == gesture.mesh.positions.bottomRows(first));
  const Points expected = gesture.mesh.positions.topRows(first).rowwise() + shift.transpose();
  CHECK((solved.positions.topRows(first) - expected).rowwise().norm().maxCoeff() < 1e-9);
}

TEST_CASE("landmarks that contradict each other end in a finite shape, and how far they are missed is said") {
  Gesture gesture{animal(2)};
  const Index v = gesture.mesh.triangles(0, 0), u = gesture.mesh.triangles(0, 1), w = gesture.mesh.triangles(0, 2);
  for (Index i = 0; i < gesture.mesh.vertexCount(); ++i) {
    if (i != v && i != u && i != w) gesture.hold(i);
  }
  // Neighbours change places through all that is held.
  gesture.move(v, gesture.at(u) + 4 * (gesture.at(u) - gesture.at(v)));
  gesture.move(u, gesture.at(v) - 4 * (gesture.at(u) - gesture.at(v)));
  const Solved solved = solve(gesture);
  if (meanError(gesture, solved.positions) > 0.5) {
    REQUIRE(!solved.warnings.empty());
    CHECK(solved.warnings.back().find("missed") != std::string::npos);
  }
}

TEST_CASE("slivers of any height neither spoil a shape nor hold a run up") {
  const Gesture whole = ear();
  const Points expected = solve(whole).positions;
  for (const double height : {0.02, 2e-3, 5e-4, 1e-6}) {
    INFO(height);
    // A cap on a side of every twelfth face.
    Gesture gesture = whole;
    TriangleMesh& mesh = gesture.mesh;
    const Index faces = mesh.faceCount(), count = mesh.vertexCount();
    for (Index f = 0; f < faces; f += 12) {
      const Index v = mesh.vertexCount(), n = mesh.faceCount();
      const Index a = mesh.triangles(f, 0), b = mesh.triangles(f, 1), c = mesh.triangles(f, 2);
      const Vec3 tip = (1 - height) / 2 * (gesture.at(a) + gesture.at(b)) + height * gesture.at(c);
      mesh.positions.conservativeResize(v + 1, 3);
      mesh.positions.row(v) = tip.transpose();
      mesh.triangles.conservativeResize(n + 2, 3);
      mesh.triangles.row(f) << a, b, v;
      mesh.triangles.row(n) << b, c, v;
      mesh.triangles.row(n + 1) << c, a, v;
    }
    const Solved solved = solve(gesture);
    CHECK(solved.outcome == Outcome::converged);
    CHECK(solved.energies.size() <= 12);
    CHECK(meanError(gesture, solved.positions) < 0.02);
    CHECK((solved.positions.topRows(count) - expected).rowwise().norm().maxCoeff() < 0.03 * diagonal(whole.mesh));
  }
}

TEST_CASE("a run that comes to its limit says that more iterations may help") {
  const Gesture gesture = ear();
  Session session;
  REQUIRE(session.load(gesture.mesh).ok());
  REQUIRE(session.select("plastic").ok());
  REQUIRE(session.set("landmarks", encoded(gesture.landmarks)).ok());
  REQUIRE(session.set("maxIterations", encoded(1)).ok());
  REQUIRE(session.prepare().ok());
  CHECK(finish(session).outcome == Outcome::iterationLimit);
  REQUIRE(!session.warnings().empty());
  CHECK(session.warnings().back().find("more may bring it nearer") != std::string::npos);
}

TEST_CASE("faces without area, doubled faces and vertices without faces do no harm") {
  const Gesture whole = ear();
  Gesture gesture = whole;
  const Index count = gesture.mesh.vertexCount(), faces = gesture.mesh.faceCount();
  gesture.mesh.positions.conservativeResize(count + 2, 3);
  gesture.mesh.positions.row(count) =
      (gesture.at(gesture.mesh.triangles(4, 0)) + gesture.at(gesture.mesh.triangles(4, 1))).transpose() / 2;
  gesture.mesh.positions.row(count + 1) = gesture.mesh.positions.row(0);
  gesture.mesh.triangles.conservativeResize(faces + 3, 3);
  gesture.mesh.triangles.row(faces) << gesture.mesh.triangles(4, 0), gesture.mesh.triangles(4, 1), count;
  gesture.mesh.triangles.row(faces + 1) = gesture.mesh.triangles.row(7);
  gesture.mesh.triangles.row(faces + 2) << 3, 3, 4;
  gesture.move(count + 1, Vec3(1, 2, 3));
  const Solved solved = solve(gesture);
  CHECK(meanError(gesture, solved.positions) < 0.02);
  CHECK((solved.positions.row(count + 1) - Eigen::RowVector3d(1, 2, 3)).norm() < 1e-12);
  CHECK((solved.positions.topRows(count) - solve(whole).positions).rowwise().norm().maxCoeff() <
        0.02 * diagonal(whole.mesh));
}

TEST_CASE("landmarks by the hundred are met as well, held by nothing but each other") {
  Gesture gesture{animal(3)};
  const double size = diagonal(gesture.mesh);
  for (Index v = 0; v < gesture.mesh.vertexCount(); v += 3) {
    const Vec3 p = gesture.at(v);
    gesture.move(v, p + 0.1 * size * Vec3(0.3 * p.y() * p.y(), 0.4 * p.x(), 0.2 * p.x() * p.z()));
  }
  CHECK(gesture.landmarks.vertices.size() > 80);
  const Solved solved = solve(gesture);
  CHECK(meanError(gesture, solved.positions) < 0.05);
  CHECK(foldCount(solved.positions, gesture.mesh.triangles) == 0);
}

TEST_CASE("targets beyond all measure are refused with their vertex") {
  Gesture gesture = ear();
  gesture.landmarks.targets.bottomRows(1) *= 1e6;
  Session session;
  REQUIRE(session.load(gesture.mesh).ok());
  REQUIRE(session.select("plastic").ok());
  REQUIRE(session.set("landmarks", encoded(gesture.landmarks)).ok());
  const Status status = session.prepare();
  CHECK(status.code == Code::badHandles);
  CHECK(status.element.index == gesture.landmarks.vertices.back());
}
