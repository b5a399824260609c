#include "reference/plain_local_global.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "geometry/cotangent.h"
#include "linear/constrained_quadratic.h"
#include "session/session.h"
#include "support/rows.h"
#include "support/shapes.h"

using namespace whittle;
using namespace whittle::testing;

// The core against the papers' iteration written down plainly in double precision. Meshes are in the unit frame
// already, so that the core's own frame changes nothing and distances are shares of the box.

namespace {

/// How far the core may stray from double precision within some iterations, as a share of the box. (What several normals
/// of a vertex hold at a kink is met to 5e-7 radians, what one holds to less.)
constexpr double kSinglePrecision = 2e-6;

/// One flap of two faces back to back (its tip has no normal), three fins on one edge, a face without area.
TriangleMesh awkward() {
  TriangleMesh mesh = bent(sphere(2));
  const Index v = mesh.vertexCount(), f = mesh.faceCount();
  const Index i = mesh.triangles(7, 0), j = mesh.triangles(7, 1);
  mesh.positions.conservativeResize(v + 4, 3);
  mesh.positions.row(v) = 1.5 * mesh.positions.row(i) + Eigen::RowVector3d(0.1, 0.2, 0);
  mesh.positions.row(v + 1) = 1.4 * mesh.positions.row(i);
  mesh.positions.row(v + 2) = 1.3 * mesh.positions.row(j) + Eigen::RowVector3d(0, 0.3, 0.1);
  mesh.positions.row(v + 3) = 0.4 * mesh.positions.row(i) + 0.6 * mesh.positions.row(j);
  mesh.triangles.conservativeResize(f + 5, 3);
  mesh.triangles.row(f) << i, j, v;
  mesh.triangles.row(f + 1) << j, i, v;
  mesh.triangles.row(f + 2) << i, j, v + 1;
  mesh.triangles.row(f + 3) << i, j, v + 2;
  mesh.triangles.row(f + 4) << i, j, v + 3;
  return mesh;
}

struct NamedMesh {
  std::string name;
  TriangleMesh mesh;
};

std::vector<NamedMesh> meshes() {
  std::vector<NamedMesh> all = {{"sphere", bent(sphere(3))},
                                {"grid", bent(grid(9))},
                                {"Moebius strip", moebiusStrip(24)},
                                {"two parts", together(bent(sphere(2)), bent(grid(6)), {3, 1, 0})},
                                {"awkward", awkward()},
                                {"block", bent(blocks({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 2))}};
  for (auto& [name, mesh] : all) mesh = inUnitFrame(std::move(mesh));
  return all;
}

/// Some vertices stay, one goes elsewhere; of two parts only the first is held.
Handles pulled(const TriangleMesh& mesh) {
  Handles handles{{0, 3, 11}, Points(3, 3)};
  for (int h = 0; h < 3; ++h) handles.targets.row(h) = mesh.positions.row(handles.vertices[h]);
  handles.targets.row(2) += Eigen::RowVector3d(0.2, -0.15, 0.25);
  return handles;
}

struct Setup {
  std::string method;
  double lambda = 0;
  std::string localStep = "exact";
  Handles handles = {};
};

/// A cube's, turned so that no normal is as near to one as to another.
Points directions() {
  const Mat3 turn = Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  Points normals(6, 3);
  normals << turn, -turn;
  return normals;
}

/// Starts a run of the plain alternation: acceleration `none`, without a tolerance.
void begin(Session& session, const TriangleMesh& mesh, const Setup& setup) {
  REQUIRE(session.load(mesh).ok());
  REQUIRE(session.select(setup.method).ok());
  if (setup.method == "cubic") {
    REQUIRE(session.set("lambda", encoded(setup.lambda)).ok());
    REQUIRE(session.set("localStep", encoded(setup.localStep)).ok());
  } else if (setup.method == "analogy") {
    REQUIRE(session.set("lambda", encoded(setup.lambda)).ok());
    REQUIRE(session.set("style", encoded(GaussMapData{.normals = directions()})).ok());
  }
  REQUIRE(session.set("acceleration", encoded("none")).ok());
  REQUIRE(session.set("tolerance", encoded(0)).ok());
  REQUIRE(session.set("handles", encoded(setup.handles)).ok());
  REQUIRE(session.prepare().ok());
}

Points positionsOf(const Session& session, const TriangleMesh& mesh) {
  Points positions(mesh.vertexCount(), 3);
  session.copyPositions(positions.data());
  return positions;
}

Points after(int iterations, const TriangleMesh& mesh, const Setup& setup) {
  Session session;
  begin(session, mesh, setup);
  StepReport report;
  for (int k = 0; k < iterations; ++k) REQUIRE(session.step(report).ok());
  return positionsOf(session, mesh);
}

Points plainAfter(int iterations, const TriangleMesh& mesh, const PlainProblem& problem) {
  PlainLocalGlobal plain(mesh, problem);
  REQUIRE(plain.prepare());
  Points positions = mesh.positions;
  plain.begin(positions);
  for (int k = 0; k < iterations; ++k) plain.iterate(positions);
  return positions;
}

/// The energy with the best rotations there are.
double energyAt(const Points& positions, const TriangleMesh& mesh, const Setup& setup) {
  PlainLocalGlobal plain(mesh, {setup.lambda, setup.handles, AdmmConstants::tight()});
  plain.assemble();
  Points copy = positions;
  plain.begin(copy);
  plain.localStep(copy);
  return plain.energy(copy);
}

double largestMove(const Points& a, const Points& b) { return (a - b).rowwise().norm().maxCoeff(); }

}  // namespace

TEST_CASE("reference: rotations and their ADMM are what they say") {
  Noise noise;
  for (int trial = 0; trial < 20; ++trial) {
    const Mat3 M = noise.matrix();
    const Mat3 R = plainRotation(M);
    CHECK((R.transpose() * R - Mat3::Identity()).norm() < 1e-12);
    CHECK(R.determinant() > 0);
    for (int other = 0; other < 20; ++other) CHECK((noise.rotation() * M).trace() <= (R * M).trace() + 1e-12);
    const Vec3 n(noise(), noise(), noise());
    const auto objective = [&](const Mat3& Q) { return (Q * M).trace() - 0.2 * (Q * n.normalized()).lpNorm<1>(); };
    AdmmState state, rough;
    const std::vector<PlainNormal> normals = {{n.normalized(), 0.2}};
    const Mat3 best = plainCubic(M, normals, AdmmConstants::tight(), {&state, 1});
    CHECK(objective(best) >= objective(R) - 1e-9);
    CHECK(objective(best) >= objective(plainCubic(M, normals, {}, {&rough, 1})) - 1e-9);
  }
}

TEST_CASE("reference: ARAP with handles goes the same way") {
  for (const NamedMesh& each : meshes()) {
    CAPTURE(each.name);
    const TriangleMesh& mesh = each.mesh;
    const Handles handles = pulled(mesh);
    for (const int iterations : {1, 15}) {
      const Points ours = after(iterations, mesh, {"arap", 0, "", handles});
      CHECK(largestMove(ours, plainAfter(iterations, mesh, {0, handles})) < kSinglePrecision);
    }
  }
}

TEST_CASE("reference: analogies with constant targets move as in double precision, and their energy is the paper's") {
  for (const NamedMesh& each : meshes()) {
    CAPTURE(each.name);
    const TriangleMesh& mesh = each.mesh;
    for (const Handles& handles : {Handles{}, pulled(mesh)}) {
      const PlainProblem problem{.handles = handles, .strength = 1.5, .style = directions()};
      const Setup setup{"analogy", 1.5, "", handles};
      CHECK(largestMove(after(15, mesh, setup), plainAfter(15, mesh, problem)) < kSinglePrecision);

      Session session;
      begin(session, mesh, setup);
      StepReport report;
      Points positions = mesh.positions;
      PlainLocalGlobal plain(mesh, problem);
      REQUIRE(plain.prepare());
      plain.begin(positions);
      for (int k = 0; k < 3; ++k) {
        REQUIRE(session.step(report).ok());
        plain.localStep(positions);
        CHECK(report.energy == doctest::Approx(plain.energy(positions)).epsilon(1e-6));
        plain.rightHandSide();
        plain.solve(positions);
      }
    }
  }
}

TEST_CASE("reference: the cubic energy is the papers'") {
  for (const NamedMesh& each : meshes()) {
    CAPTURE(each.name);
    const TriangleMesh& mesh = each.mesh;
    const Setup setup{"cubic", 0.4};
    Session session;
    begin(session, mesh, setup);
    StepReport report;
    for (int k = 0; k < 3; ++k) {
      const Points before = positionsOf(session, mesh);
      REQUIRE(session.step(report).ok());
      CHECK(report.energy == doctest::Approx(energyAt(before, mesh, setup)).epsilon(1e-6));
    }
  }
}

TEST_CASE("reference: the exact step goes the way of an ADMM run to its end") {
  for (const NamedMesh& each : meshes()) {
    CAPTURE(each.name);
    const TriangleMesh& mesh = each.mesh;
    for (const Handles& handles : {Handles{}, pulled(mesh)}) {
      const Points plain = plainAfter(4, mesh, {0.4, handles, AdmmConstants::tight()});
      CHECK(largestMove(after(4, mesh, {"cubic", 0.4, "exact", handles}), plain) < kSinglePrecision);
    }
  }
}

TEST_CASE("reference: cubic ends no higher than the printed iteration") {
  constexpr int kIterations = 60;
  for (const NamedMesh& each : meshes()) {
    CAPTURE(each.name);
    const TriangleMesh& mesh = each.mesh;
    for (const Handles& handles : {Handles{}, pulled(mesh)}) {
      const Points plain = plainAfter(kIterations, mesh, {0.4, handles});
      for (const std::string localStep : {"exact", "admm"}) {
        CAPTURE(localStep);
        CAPTURE(handles.vertices.size());
        const Setup setup{"cubic", 0.4, localStep, handles};
        const double bound = energyAt(plain, mesh, setup);
        const double ours = energyAt(after(kIterations, mesh, setup), mesh, setup);
        CHECK(ours <= bound * (1 + 2e-4));
      }
    }
  }
}

TEST_CASE("reference: linear solves agree with Eigen's in double precision") {
  Noise noise;
  for (const NamedMesh& each : meshes()) {
    CAPTURE(each.name);
    const TriangleMesh& mesh = each.mesh;
    const SparseMatrix L =
        cotangentLaplacian(mesh.triangles, halfCotangents(mesh.positions, mesh.triangles), mesh.vertexCount());
    std::vector<Index> held = {0, 5};
    if (connectedComponents(mesh.triangles, mesh.vertexCount()).count > 1) held.push_back(mesh.vertexCount() - 1);
    Points residual(mesh.vertexCount(), 3);
    for (Index v = 0; v < mesh.vertexCount(); ++v) residual.row(v) << noise(), noise(), noise();

    ConstrainedQuadratic system;
    REQUIRE(system.prepare(L, held).ok());
    LaneRows moves = toRows(residual);
    moves.resize(ConstrainedQuadratic::paddedRows(mesh.vertexCount()));
    system.correct(moves);
    const Points ours = toPoints(moves, mesh.vertexCount());

    // Held rows and columns become those of the identity, with zero on the right.
    SparseMatrix A = L;
    for (const Index v : held) residual.row(v).setZero();
    A.prune([&](Index row, Index column, double) {
      const auto isHeld = [&](Index v) { return std::find(held.begin(), held.end(), v) != held.end(); };
      return row == column || (!isHeld(row) && !isHeld(column));
    });
    const Eigen::SimplicialLLT<SparseMatrix> plain(A);
    REQUIRE(plain.info() == Eigen::Success);
    const Eigen::MatrixXd expected = plain.solve(Eigen::MatrixXd(residual));
    CHECK((ours - expected).norm() < 1e-5 * expected.norm());
  }
}
