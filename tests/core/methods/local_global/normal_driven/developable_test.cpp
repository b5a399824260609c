#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <string>

#include "geometry/surface.h"
#include "methods/local_global/normal_driven/developable_normals.h"
#include "support/allocations.h"
#include "support/shapes.h"
#include "support/style_runs.h"
#include "support/surface_measures.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

struct Creased {
  double lambda = 20;
  double creases = 0.5;
  int maxIterations = 100;
  Handles handles = {};
};

void prepareCreased(Session& session, const Creased& creased) {
  REQUIRE(session.select("developable").ok());
  REQUIRE(session.set("lambda", encoded(creased.lambda)).ok());
  REQUIRE(session.set("creases", encoded(creased.creases)).ok());
  REQUIRE(session.set("maxIterations", encoded(creased.maxIterations)).ok());
  REQUIRE(session.set("handles", encoded(creased.handles)).ok());
  REQUIRE(session.prepare().ok());
}

Run crease(const TriangleMesh& mesh, const Creased& creased) {
  Session session;
  REQUIRE(session.load(mesh).ok());
  prepareCreased(session, creased);
  return finish(session);
}

double largestMove(const Points& a, const Points& b) { return (a - b).rowwise().norm().maxCoeff(); }

/// Eigenvalues in falling order and what a ring makes of normals, by the book.
struct PlainRing {
  Vec3 e;
  Mat3 vectors;
};

std::vector<PlainRing> plainRings(const TriangleMesh& mesh) {
  const Points normals = faceNormals(mesh.positions, mesh.triangles);
  const Scalars areas = faceAreas(mesh.positions, mesh.triangles);
  std::vector<Mat3> C(mesh.vertexCount(), Mat3::Zero());
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    for (int k = 0; k < 3; ++k) C[mesh.triangles(f, k)] += areas[f] * normals.row(f).transpose() * normals.row(f);
  }
  std::vector<PlainRing> rings;
  for (const Mat3& matrix : C) {
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(matrix);
    rings.push_back({solver.eigenvalues().reverse(), solver.eigenvectors().rowwise().reverse()});
  }
  return rings;
}

/// A piece of a hyperbolic paraboloid: it has a boundary and no two directions alike.
TriangleMesh saddle() {
  TriangleMesh mesh = grid(12);
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    const double x = mesh.positions(v, 0) - 0.3, y = mesh.positions(v, 1) - 0.4;
    mesh.positions(v, 2) = x * x - 0.4 * y * y + 0.3 * x * y * y;
  }
  return mesh;
}

/// How the Gaussian curvature lies on a surface.
struct Spread {
  double flat;  // share of the vertices that have next to none
  double top;   // share of the whole that the twentieth with the most holds
};

Spread spread(const Points& positions, const Triangles& triangles, double small) {
  Scalars defects = angleDefects(positions, triangles).cwiseAbs();
  std::sort(defects.begin(), defects.end());
  const Index count = static_cast<Index>(defects.size());
  return {static_cast<double>((defects.array() < small).count()) / count,
          defects.tail(count / 20).sum() / defects.sum()};
}

}  // namespace

TEST_CASE("targets are those of a plain eigen-solver") {
  for (const TriangleMesh& mesh : {animal(3), bent(torus(20)), saddle()}) {
    const std::vector<PlainRing> rings = plainRings(mesh);
    const Points normals = faceNormals(mesh.positions, mesh.triangles);
    std::vector<double> bends;
    for (const PlainRing& ring : rings) bends.push_back(ring.e[1] / ring.e[0]);
    std::sort(bends.begin(), bends.end());
    for (const double creases : {0.0, 0.4, 1.0}) {
      const double threshold = bends[static_cast<std::size_t>((1 - creases) * (bends.size() - 1))];
      DevelopableNormals developable;
      developable.prepare(mesh, creases);
      int compared = 0;
      for (Index f = 0; f < mesh.faceCount(); ++f) {
        Vec3 target = Vec3::Zero();
        bool isClear = true;  // no ring stands at the threshold or has two directions alike
        for (int k = 0; k < 3; ++k) {
          const auto& [e, vectors] = rings[mesh.triangles(f, k)];
          const double bend = e[1] / e[0];
          const bool isFlat = bend < threshold;
          isClear &= std::abs(bend - threshold) > 1e-5 && (isFlat || e[1] > 1.2 * e[2] + 1e-4 * e[0]);
          const Vec3 n = normals.row(f).transpose();
          target +=
              isFlat ? Vec3(vectors.col(0) * vectors.col(0).dot(n)) : Vec3(n - vectors.col(2) * vectors.col(2).dot(n));
        }
        if (!isClear) continue;
        ++compared;
        CHECK((developable(f) - target).norm() < 1e-4);
      }
      CHECK(compared > mesh.faceCount() / 3);
    }
  }
}

TEST_CASE("curvature leaves most of the surface and gathers on creases") {
  const struct {
    std::string name;
    TriangleMesh mesh;
  } cases[] = {{"animal", animal(5)}, {"bent torus", bent(torus(48))}, {"egg", bent(sphere(5))}};
  for (const auto& [name, mesh] : cases) {
    const Scalars before = angleDefects(mesh.positions, mesh.triangles).cwiseAbs();
    const double small = 0.2 * before.mean();
    const Spread was = spread(mesh.positions, mesh.triangles, small);
    const Run result = crease(mesh, Creased());
    const Spread is = spread(result.positions, mesh.triangles, small);
    MESSAGE(name << ": without curvature " << was.flat << " → " << is.flat << ", on its twentieth " << was.top << " → "
                 << is.top);
    CHECK(is.flat > was.flat + 0.2);
    CHECK(is.top > 1.2 * was.top);
    CHECK(foldCount(result.positions, mesh.triangles) == 0);
    const double area =
        faceAreas(result.positions, mesh.triangles).sum() / faceAreas(mesh.positions, mesh.triangles).sum();
    CHECK(area == doctest::Approx(1).epsilon(0.01));
  }
}

TEST_CASE("what is developable stays: a cylinder, a sheet, a box") {
  TriangleMesh cylinder = grid(16);
  for (Index v = 0; v < cylinder.vertexCount(); ++v) {
    const double angle = 2 * cylinder.positions(v, 0);
    cylinder.positions.row(v) << std::sin(angle) / 2, cylinder.positions(v, 1), std::cos(angle) / 2;
  }
  for (const TriangleMesh& mesh : {cylinder, grid(9)}) {
    CHECK(largestMove(crease(mesh, {20, 1}).positions, mesh.positions) < 1e-4);
  }
}

TEST_CASE("without lambda the mesh stays, to the bit; handles are met") {
  const TriangleMesh mesh = animal(3);
  CHECK(largestMove(crease(mesh, {0}).positions, mesh.positions) == 0);
  Handles handles{{0, 5, 9}, Points(3, 3)};
  for (int h = 0; h < 3; ++h) handles.targets.row(h) = mesh.positions.row(handles.vertices[h]);
  handles.targets.row(1) += Eigen::RowVector3d(0.3, 0.5, -0.1);
  const Points held = crease(mesh, {20, 0.5, 40, handles}).positions;
  for (int h = 0; h < 3; ++h) CHECK((held.row(handles.vertices[h]) - handles.targets.row(h)).norm() < 1e-9);
}

TEST_CASE("turning the mesh turns its creases, another order of vertices is another order") {
  const TriangleMesh mesh = animal(3);
  const Creased creased{20, 0.5, 6};  // rings at the threshold decide by rounding, and then go their own ways
  const Points plain = crease(mesh, creased).positions;
  const double way = largestMove(plain, mesh.positions);
  const Points other = crease(shuffled(mesh), creased).positions;
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    CHECK((other.row(shuffledPlace(v, mesh.vertexCount())) - plain.row(v)).norm() < 1e-2 * way);
  }
  const Mat3 R = someRotation();
  CHECK(largestMove(crease({mesh.positions * R.transpose(), mesh.triangles}, creased).positions,
                    plain * R.transpose()) < 1e-2 * way);
}

TEST_CASE("it runs for as many iterations as it is told, however the energy goes") {
  const TriangleMesh mesh = animal(2);
  for (const int count : {1, 30, 260}) {
    const Run result = crease(mesh, {20, 0.5, count});
    CHECK(result.outcome == Outcome::iterationLimit);
    CHECK(static_cast<int>(result.energies.size()) == count);
  }
  const Run still = crease(grid(5), {20, 1, 50});
  CHECK(still.outcome == Outcome::converged);
}

TEST_CASE("faces without area and rings without faces are no trouble") {
  TriangleMesh mesh = animal(2);
  const Index count = mesh.vertexCount(), faces = mesh.faceCount();
  mesh.positions.conservativeResize(count + 4, 3);
  mesh.positions.bottomRows<4>() << 2, 0, 0, 3, 0, 0, 2, 1, 0, 0.1, 0.2, 0.3;
  mesh.triangles.conservativeResize(faces + 3, 3);
  mesh.triangles.row(faces) << count, count + 1, count + 2;
  mesh.triangles.row(faces + 1) << count, count + 2, count + 1;
  mesh.triangles.row(faces + 2) << 0, 0, 1;
  const Run result = crease(mesh, Creased());
  CHECK(result.positions.allFinite());
  CHECK(result.positions.bottomRows<1>() == mesh.positions.bottomRows<1>());
}

TEST_CASE("developable: the same bits twice, and a step allocates nothing") {
  const TriangleMesh mesh = animal(3);
  const Creased creased{20, 0.5, 30};
  CHECK(crease(mesh, creased).positions == crease(mesh, creased).positions);
  Session session;
  REQUIRE(session.load(mesh).ok());
  prepareCreased(session, creased);
  StepReport report;
  const long before = allocationCount();
  for (int step = 0; step < 5; ++step) REQUIRE(session.step(report).ok());
  CHECK(allocationCount() == before);
}
