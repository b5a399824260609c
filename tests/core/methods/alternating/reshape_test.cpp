#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "geometry/surface.h"
#include "methods/values/chains.h"
#include "methods/values/handles.h"
#include "support/round_shapes.h"
#include "support/runs.h"
#include "support/shapes.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

/// Handles of all vertices that `chooses` takes, moved as `move` says.
template <typename Chooses, typename Move>
Handles handlesOn(const TriangleMesh& mesh, Chooses chooses, Move move) {
  Handles handles;
  std::vector<Vec3> targets;
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    const Vec3 place = mesh.positions.row(v).transpose();
    if (!chooses(place)) continue;
    handles.vertices.push_back(v);
    targets.push_back(move(place));
  }
  handles.targets.resize(static_cast<Index>(targets.size()), 3);
  for (Index i = 0; i < handles.targets.rows(); ++i) handles.targets.row(i) = targets[i].transpose();
  return handles;
}

struct Reshaping {
  TriangleMesh mesh;
  Handles handles;
  std::string variant = "slippage";
  std::string reading = "tuned";
  std::string remesh = "auto";

  Run run() const {
    Session session;
    REQUIRE(session.load(mesh).ok());
    REQUIRE(session.select("reshape").ok());
    REQUIRE(session.set("variant", encoded(variant)).ok());
    REQUIRE(session.set("reading", encoded(reading)).ok());
    REQUIRE(session.set("remesh", encoded(remesh)).ok());
    REQUIRE(session.set("handles", encoded(handles)).ok());
    REQUIRE(session.prepare().ok());
    return finish(session);
  }
};

constexpr double kHeight = 4;

/// A staggered cylinder, held at one end and pulled out at the other: whole caps, or their middles.
Reshaping pulledCylinder(bool wholeCaps, double factor) {
  Reshaping reshaping{cylinder(32, 24, 5, 1, kHeight, true), {}};
  const auto isEnd = [=](const Vec3& p) {
    const bool isOnCap = p.z() < 1e-9 || p.z() > kHeight - 1e-9;
    return isOnCap && (wholeCaps || p.head<2>().norm() < 1e-9);
  };
  reshaping.handles = handlesOn(reshaping.mesh, isEnd, [=](const Vec3& p) {
    return Vec3(p.x(), p.y(), p.z() > kHeight / 2 ? factor * p.z() : p.z());
  });
  return reshaping;
}

/// Mean radius of the side about z, over that at rest.
double radiusRatio(const TriangleMesh& mesh, const Points& positions) {
  double sum = 0, count = 0;
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    const Eigen::RowVector3d rest = mesh.positions.row(v);
    if (rest.head<2>().norm() < 0.999 || rest.z() < 0.5 || rest.z() > kHeight - 0.5) continue;
    sum += positions.row(v).head<2>().norm();
    ++count;
  }
  return sum / count;
}

double largestTurn(const TriangleMesh& mesh, const Points& positions) {
  const Points before = faceNormals(mesh.positions, mesh.triangles), after = faceNormals(positions, mesh.triangles);
  return std::acos(std::min(1.0, before.cwiseProduct(after).rowwise().sum().minCoeff())) * 180 / EIGEN_PI;
}

}  // namespace

TEST_CASE("a cylinder that is lengthened keeps its radius; as printed it grows fat") {
  for (const bool wholeCaps : {true, false}) {
    for (const double factor : {1.6, 0.7}) {
      Reshaping reshaping = pulledCylinder(wholeCaps, factor);
      const Run run = reshaping.run();
      CHECK(run.outcome == Outcome::converged);
      CHECK(radiusRatio(reshaping.mesh, run.positions) == doctest::Approx(1).epsilon(0.01));
      CHECK(run.positions.col(2).maxCoeff() == doctest::Approx(factor * kHeight).epsilon(0.001));
      CHECK(largestTurn(reshaping.mesh, run.positions) < 3);
    }
  }
  Reshaping printed = pulledCylinder(false, 1.6);
  printed.reading = "published";
  const double ratio = radiusRatio(printed.mesh, printed.run().positions);
  CHECK(ratio > 1.3);
  CHECK(ratio < 1.6);
}

TEST_CASE("without a gesture every variant gives the input to the bit") {
  for (const char* variant : {"slippage", "alup", "poisson", "arap", "conformal"}) {
    Reshaping reshaping = pulledCylinder(true, 1);
    reshaping.variant = variant;
    CHECK(reshaping.run().positions == reshaping.mesh.positions);
    reshaping.handles = {};
    CHECK(reshaping.run().positions == reshaping.mesh.positions);
  }
}

TEST_CASE("one handle alone takes everything along, and all handles go where they are told") {
  Reshaping one{torus(12), {{7}, Points::Zero(1, 3)}};
  const Eigen::RowVector3d move(0.3, -0.2, 0.5);
  one.handles.targets.row(0) = one.mesh.positions.row(7) + move;
  CHECK(((one.run().positions - one.mesh.positions).rowwise() - move).cwiseAbs().maxCoeff() < 1e-5);

  Reshaping all{torus(24), {}};
  const Mat3 stretch = Vec3(1.3, 1, 0.8).asDiagonal();
  const auto everywhere = [](const Vec3&) { return true; };
  all.handles = handlesOn(all.mesh, everywhere, [&](const Vec3& p) -> Vec3 { return stretch * p; });
  CHECK((all.run().positions - all.handles.targets).rowwise().norm().maxCoeff() < 0.005 * 3);  // of the diagonal
}

TEST_CASE("a gesture that scales evenly gives an even scale in ALUP") {
  Reshaping reshaping{turned(cylinder(16, 10, 3, 1, 2, true)), {}, "alup"};
  const auto some = [&](const Vec3& p) { return static_cast<int>(std::abs(p.sum()) * 1000) % 23 == 0; };
  reshaping.handles = handlesOn(reshaping.mesh, some, [](const Vec3& p) -> Vec3 { return 1.5 * p; });
  REQUIRE(reshaping.handles.vertices.size() >= 4);
  CHECK((reshaping.run().positions - 1.5 * reshaping.mesh.positions).cwiseAbs().maxCoeff() < 0.01);
}

TEST_CASE("another order of the vertices and another run change nothing that counts") {
  const Reshaping reshaping = pulledCylinder(false, 1.6);
  const Run run = reshaping.run();
  CHECK(reshaping.run().positions == run.positions);

  Reshaping other = reshaping;
  other.mesh = shuffled(reshaping.mesh);
  for (Index& v : other.handles.vertices) v = shuffledPlace(v, reshaping.mesh.vertexCount());
  const Points shuffledPositions = other.run().positions;
  double largest = 0;
  for (Index v = 0; v < reshaping.mesh.vertexCount(); ++v) {
    const Index place = shuffledPlace(v, reshaping.mesh.vertexCount());
    largest = std::max(largest, (run.positions.row(v) - shuffledPositions.row(place)).norm());
  }
  CHECK(largest < 1e-3);
}

TEST_CASE("a run that goes on from the gesture before ends near the one from rest") {
  Session session;
  const Reshaping half = pulledCylinder(true, 1.5), whole = pulledCylinder(true, 1.6);
  REQUIRE(session.load(half.mesh).ok());
  REQUIRE(session.select("reshape").ok());
  REQUIRE(session.set("handles", encoded(half.handles)).ok());
  REQUIRE(session.prepare().ok());
  finish(session);
  REQUIRE(session.set("handles", encoded(whole.handles)).ok());
  REQUIRE(session.prepare().ok());
  StepReport report;
  REQUIRE(session.step(report).ok());
  Points warm(whole.mesh.vertexCount(), 3);
  session.copyPositions(warm.data());
  CHECK((warm - whole.run().positions).rowwise().norm().maxCoeff() < 0.01 * std::hypot(2.83, kHeight));
}

TEST_CASE("a run from rest gives the very bits that it gives alone, whatever ran before") {
  for (const char* variant : {"slippage", "alup", "poisson"}) {
    Reshaping far = pulledCylinder(false, 2.5), near = pulledCylinder(false, 1.3);
    far.variant = near.variant = variant;
    Session session;
    REQUIRE(session.load(near.mesh).ok());
    REQUIRE(session.select("reshape").ok());
    REQUIRE(session.set("variant", encoded(std::string(variant))).ok());
    for (const Reshaping* gesture : {&near, &far, &near}) {
      session.restart();
      REQUIRE(session.set("handles", encoded(gesture->handles)).ok());
      REQUIRE(session.prepare().ok());
      CHECK(finish(session).positions == gesture->run().positions);
    }
  }
}

TEST_CASE("a drag that is overtaken in the middle of an iteration leaves no trace in the run from rest") {
  const Reshaping whole = pulledCylinder(false, 1.6);
  const Points alone = whole.run().positions;
  for (int slices = 1; slices <= 16; slices *= 2) {
    Session session;
    REQUIRE(session.load(whole.mesh).ok());
    REQUIRE(session.select("reshape").ok());
    StepReport report;
    for (const double factor : {1.2, 1.3, 1.6}) {
      REQUIRE(session.set("handles", encoded(pulledCylinder(false, factor).handles)).ok());
      REQUIRE(session.prepare().ok());
      for (int slice = 0; slice < slices; ++slice) REQUIRE(session.step(report).ok());
    }
    session.restart();
    REQUIRE(session.prepare().ok());
    CHECK(finish(session).positions == alone);
  }
}

TEST_CASE("a wall that is pulled across stays as thick as it is") {
  // An L: an upright of seven cubes, and six more lying at its foot.
  Reshaping reshaping{blocks({{0, 0, 0},
                              {0, 1, 0},
                              {0, 2, 0},
                              {0, 3, 0},
                              {0, 4, 0},
                              {0, 5, 0},
                              {0, 6, 0},
                              {1, 0, 0},
                              {2, 0, 0},
                              {3, 0, 0},
                              {4, 0, 0},
                              {5, 0, 0},
                              {6, 0, 0}},
                             4),
                      {}};
  const double length = reshaping.mesh.positions.col(0).maxCoeff();
  const auto isEnd = [=](const Vec3& p) { return p.x() < 1e-9 || p.x() > length - 1e-9; };
  reshaping.handles = handlesOn(
      reshaping.mesh, isEnd, [=](const Vec3& p) -> Vec3 { return p + (p.x() > 1 ? 0.6 * length : 0) * Vec3::UnitX(); });
  const auto thickness = [&](const Points& positions) {
    double sum = 0, count = 0;
    for (Index v = 0; v < positions.rows(); ++v) {
      const Eigen::RowVector3d rest = reshaping.mesh.positions.row(v);
      if (std::abs(rest.x() - 1) > 1e-9 || rest.y() < 2) continue;
      sum += positions(v, 0), ++count;
    }
    return sum / count;
  };
  CHECK(thickness(reshaping.run().positions) == doctest::Approx(1).epsilon(0.02));
  reshaping.reading = "published";
  CHECK(thickness(reshaping.run().positions) > 1.2);
}

TEST_CASE("half a bar is held and its end pulled: handles are met") {
  Reshaping reshaping{longBox(24, 6), {}};
  const double length = reshaping.mesh.positions.col(0).maxCoeff(), low = reshaping.mesh.positions.col(0).minCoeff();
  const double middle = (length + low) / 2;
  const auto isHeld = [=](const Vec3& p) { return p.x() < middle || p.x() > length - 1e-9; };
  reshaping.handles = handlesOn(reshaping.mesh, isHeld, [=](const Vec3& p) -> Vec3 {
    return p + (p.x() > middle ? 0.6 * (length - low) : 0) * Vec3::UnitX();
  });
  const Run run = reshaping.run();
  for (std::size_t h = 0; h < reshaping.handles.vertices.size(); ++h) {
    const double missed =
        (run.positions.row(reshaping.handles.vertices[h]) - reshaping.handles.targets.row(static_cast<Index>(h)))
            .norm();
    CHECK(missed < 0.002 * (length - low));
  }
}

TEST_CASE("what cannot be is refused, and what is far away is a mistake") {
  Reshaping inside = pulledCylinder(true, -1);
  Session session;
  REQUIRE(session.load(inside.mesh).ok());
  REQUIRE(session.select("reshape").ok());
  REQUIRE(session.set("handles", encoded(inside.handles)).ok());
  REQUIRE(session.prepare().ok());
  StepReport report;
  Status status;
  while (status.ok() && (report.outcome == Outcome::running || report.outcome == Outcome::midway))
    status = session.step(report);
  CHECK(status.code == Code::badHandles);
  CHECK(status.message.find("inside out") != std::string::npos);

  inside.handles.targets(3, 0) = 1e9;
  REQUIRE(session.set("handles", encoded(inside.handles)).ok());
  status = session.prepare();
  CHECK(status.code == Code::badHandles);
  CHECK(status.element.index == inside.handles.vertices[3]);
}

namespace {

/// A bar of length 4 along x, held at one end and pulled at the other.
Reshaping pulledBar() {
  Reshaping reshaping{longBox(12, 3), {}};
  const auto isEnd = [](const Vec3& p) { return p.x() < 1e-9 || p.x() > 4 - 1e-9; };
  reshaping.handles =
      handlesOn(reshaping.mesh, isEnd, [](const Vec3& p) -> Vec3 { return p + (p.x() > 1 ? 1 : 0) * Vec3::UnitX(); });
  return reshaping;
}

Index vertexAt(const TriangleMesh& mesh, const Vec3& place) {
  Index nearest = 0;
  (mesh.positions.rowwise() - place.transpose()).rowwise().norm().minCoeff(&nearest);
  return nearest;
}

/// What a run says that works on the file's own faces and has lines of a parameter.
std::vector<std::string> saidOf(const Reshaping& reshaping, const char* name, const VertexChains& lines) {
  Session session;
  REQUIRE(session.load(reshaping.mesh).ok());
  REQUIRE(session.select("reshape").ok());
  REQUIRE(session.set("handles", encoded(reshaping.handles)).ok());
  REQUIRE(session.set("remesh", encoded("never")).ok());
  REQUIRE(session.set(name, encoded(lines)).ok());
  REQUIRE(session.prepare().ok());
  finish(session);
  return session.warnings();
}

}  // namespace

TEST_CASE("lines that mark nothing are told of by their number") {
  const Reshaping bar = pulledBar();
  const auto at = [&](double x, double y, double z) { return vertexAt(bar.mesh, Vec3(x, y, z)); };
  const std::vector<Index> side = {at(0, 0, 0), at(4, 0, 0)}, through = {at(0, 0, 0), at(4, 1, 1)};
  const std::vector<Index> leaving = {at(0, 0, 0), at(1 / 3.0, 0, 0), at(4, 1, 1)};
  const std::vector<Index> edge = {at(0, 0, 0), at(1 / 3.0, 0, 0)};
  for (const char* name : {"features", "smooth"}) {
    const std::string end = std::string(" of “") + name + "” ";
    CHECK(saidOf(bar, name, {side, through, leaving}) ==
          std::vector<std::string>{
              "Line 2" + end + "lies along no edge of the mesh, so that it marks nothing.",
              "Line 3" + end + "leaves the edges of the mesh; it marks those that it lies along.",
          });
  }
  CHECK(saidOf(bar, "straight", {side, through, edge}) ==
        std::vector<std::string>{
            "Line 2 of “straight” lies along no edge of the mesh, so that it marks nothing.",
            "Line 3 of “straight” has fewer than three vertices where the work is done, so that it keeps nothing "
            "straight.",
        });
}

TEST_CASE("faces without area are left out of the work and come back") {
  Reshaping bar = pulledBar();
  const Points whole = bar.run().positions;
  bar.mesh.triangles.conservativeResize(bar.mesh.faceCount() + 1, 3);
  bar.mesh.triangles.bottomRows<1>() << 0, 1, 1;
  CHECK((bar.run().positions - whole).cwiseAbs().maxCoeff() < 1e-9);
  CHECK(saidOf(bar, "straight", {}) ==
        std::vector<std::string>{
            "1 face that is too thin or repeats another is left out of the work; it follows the rest."});
}

TEST_CASE("a vertex without a face goes where it is told, else it stays") {
  Reshaping bar = pulledBar();
  const Index count = bar.mesh.vertexCount();
  bar.mesh.positions.conservativeResize(count + 2, 3);
  bar.mesh.positions.bottomRows<2>() << 1, 2, 0, 2, 2, 0;
  const Points without = bar.run().positions;
  CHECK(without.bottomRows<2>() == bar.mesh.positions.bottomRows<2>());
  bar.handles.vertices.push_back(count);
  bar.handles.targets.conservativeResize(bar.handles.targets.rows() + 1, 3);
  bar.handles.targets.bottomRows<1>() << 1, 3, 0.5;
  for (const char* variant : {"slippage", "alup", "poisson", "arap", "conformal"}) {
    for (const char* remesh : {"auto", "always"}) {
      bar.variant = variant;
      bar.remesh = remesh;
      const Points with = bar.run().positions;
      CHECK((with.row(count) - bar.handles.targets.bottomRows<1>()).norm() < 1e-3);
      CHECK(with.row(count + 1) == bar.mesh.positions.row(count + 1));
      if (bar.variant == "slippage" && bar.remesh == "auto")
        CHECK((with.topRows(count) - without.topRows(count)).cwiseAbs().maxCoeff() < 1e-4);
    }
  }
}
