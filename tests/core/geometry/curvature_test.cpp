#include "geometry/curvature.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "geometry/feature_edges.h"
#include "support/round_shapes.h"
#include "support/shapes.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

Curvatures curvaturesOf(const TriangleMesh& mesh) {
  const MeshEdges edges(mesh.triangles, mesh.vertexCount());
  const auto pairs = facePairs(mesh.positions, mesh.triangles, edges);
  CurvatureEstimate estimate(mesh.positions, mesh.triangles, edges,
                             featureEdges(pairs, edges.count(), 40 * EIGEN_PI / 180));
  double share = 0;
  while (share < 1) {
    const double before = share;
    share = estimate.next();
    REQUIRE(share > before);
  }
  return estimate.take();
}

Vec3 centroid(const TriangleMesh& mesh, Index f) {
  Vec3 sum = Vec3::Zero();
  for (int k = 0; k < 3; ++k) sum += mesh.positions.row(mesh.triangles(f, k)).transpose();
  return sum / 3;
}

double largestError(const Scalars& values, double wanted) { return (values.array() - wanted).abs().maxCoeff(); }

/// Where the way around z goes at the faces of a mesh, once it is turned.
auto aroundZ(const TriangleMesh& straight) {
  return
      [&straight](Index f) -> Vec3 { return someRotation() * Vec3::UnitZ().cross(centroid(straight, f)).normalized(); };
}

/// Largest sine of the angle between the directions of faces and where they should be.
double largestTurn(const Curvatures& curvatures, const std::function<Vec3(Index)>& wanted) {
  double worst = 0;
  for (Index f = 0; f < curvatures.direction.rows(); ++f) {
    const Vec3 direction = curvatures.direction.row(f).transpose();
    CHECK(direction.norm() == doctest::Approx(1));
    worst = std::max(worst, direction.cross(wanted(f)).norm());
  }
  return worst;
}

}  // namespace

TEST_CASE("a sphere curves by 1 / r in both directions, coarse or fine") {
  for (const int levels : {2, 3, 5}) {
    TriangleMesh mesh = turned(sphere(levels));
    mesh.positions *= 0.5;
    const Curvatures curvatures = curvaturesOf(mesh);
    const double limit = levels == 2 ? 0.04 : levels == 3 ? 0.02 : 0.002;
    CHECK(largestError(curvatures.larger, 2) < limit);
    CHECK(largestError(curvatures.smaller, 2) < limit);
  }
  TriangleMesh inside = sphere(3);
  inside.triangles.col(1).swap(inside.triangles.col(2));
  CHECK(largestError(curvaturesOf(inside).larger, -1) < 0.01);
}

TEST_CASE("a tube curves by 1 / r around, and around is the direction, from ten sides on, at its ends as well") {
  for (const bool staggered : {false, true}) {
    for (const int sides : {10, 16, 48}) {
      const TriangleMesh straight = tube(sides, std::max(sides / 2, 4), 0.25, 1, staggered), mesh = turned(straight);
      const Curvatures curvatures = curvaturesOf(mesh);
      CHECK(largestError(curvatures.larger, 4) < (sides == 10 ? 0.06 : 0.01));
      CHECK(largestError(curvatures.smaller, 0) < (sides == 10 ? 0.02 : 0.012));
      CHECK(largestTurn(curvatures, aroundZ(straight)) <
            (sides == 48 ? 0.07 : 0.32));  // half a side at most: facets are flat
    }
  }
}

TEST_CASE("one row of faces around a hole is as round as the hole") {
  for (const int sides : {10, 24}) {
    const TriangleMesh straight = tube(sides, 1, 0.1, 0.05, false);
    TriangleMesh hole = turned(straight);
    hole.triangles.col(1).swap(hole.triangles.col(2));  // seen from within
    const Curvatures curvatures = curvaturesOf(hole);
    CHECK(largestError(curvatures.smaller, -10) < 0.02);
    CHECK(largestError(curvatures.larger, 0) < 0.05);
    CHECK(largestTurn(curvatures, aroundZ(straight)) < (sides == 24 ? 0.14 : 0.32));
  }
}

TEST_CASE("a torus curves by 1 / r around its tube and by cos φ / (R + r cos φ) along it") {
  const double R = 1, r = 0.4;
  const auto place = [&](double u, double v) {
    const double along = 2 * EIGEN_PI * u, around = 2 * EIGEN_PI * v, ring = R + r * std::cos(around);
    return Vec3(ring * std::cos(along), ring * std::sin(along), r * std::sin(around));
  };
  for (const int n : {24, 60}) {
    const TriangleMesh mesh = turned(sheet({5 * n / 2, n, true, true, true}, place));
    const Curvatures curvatures = curvaturesOf(mesh);
    Scalars wanted(mesh.faceCount());
    for (Index f = 0; f < mesh.faceCount(); ++f) {
      const Vec3 c = someRotation().transpose() * centroid(mesh, f);
      const double cosine = (std::hypot(c[0], c[1]) - R) / r;
      wanted[f] = cosine / (R + r * cosine);
    }
    CHECK(largestError(curvatures.larger, 1 / r) < (n == 24 ? 0.05 : 0.01));
    CHECK((curvatures.smaller - wanted).cwiseAbs().maxCoeff() < (n == 24 ? 0.08 : 0.015));
  }
}

TEST_CASE("a saddle curves both ways, a plane neither, a box nowhere at its sides") {
  const auto saddle = [](double u, double v) { return Vec3(u - 0.5, v - 0.5, (u - 0.5) * (v - 0.5)); };
  const TriangleMesh mesh = turned(sheet({40, 40}, saddle));
  const Curvatures curvatures = curvaturesOf(mesh);
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    const Vec3 c = someRotation().transpose() * centroid(mesh, f);
    const double w = 1 + c[0] * c[0] + c[1] * c[1], H = -c[0] * c[1] / std::pow(w, 1.5), K = -1 / (w * w);
    const double radius = std::sqrt(H * H - K);
    CHECK(curvatures.larger[f] == doctest::Approx(radius - H).epsilon(0.06));
    CHECK(curvatures.smaller[f] == doctest::Approx(-radius - H).epsilon(0.06));
  }
  for (const TriangleMesh& flat :
       {turned(grid(12)), turned(longBox(4, 3)), turned(blocks({{0, 0, 0}, {1, 0, 0}}, 1))}) {
    CHECK(largestError(curvaturesOf(flat).larger, 0) < 1e-9);
    CHECK(largestError(curvaturesOf(flat).smaller, 0) < 1e-9);
  }
  CHECK(curvaturesOf(grid(12)).direction.isZero(0));
}

TEST_CASE("a closed cylinder is a tube and two flat ends: no rim looks round both ways") {
  const TriangleMesh mesh = turned(cylinder(24, 9, 3, 0.3, 1, true));
  const Curvatures curvatures = curvaturesOf(mesh);
  const Vec3 axis = someRotation().col(2);
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    const Vec3 a = mesh.positions.row(mesh.triangles(f, 0)), b = mesh.positions.row(mesh.triangles(f, 1)),
               c = mesh.positions.row(mesh.triangles(f, 2));
    const bool isEnd = std::abs((b - a).cross(c - a).normalized().dot(axis)) > 0.5;
    CHECK(curvatures.larger[f] == doctest::Approx(isEnd ? 0 : 1 / 0.3).epsilon(0.01));
    CHECK(std::abs(curvatures.smaller[f]) < 0.02);
  }
}

TEST_CASE("a whole that is not one surface is cut where it is none, and rubbish stays finite") {
  // A fin on a ridge: the plane below is as flat as without it.
  TriangleMesh fin = grid(6);
  fin.positions.conservativeResize(fin.vertexCount() + 1, 3);
  fin.positions.bottomRows<1>() << 0.5, 0.5, 0.5;
  fin.triangles.conservativeResize(fin.faceCount() + 3, 3);
  fin.triangles.bottomRows<3>() << 14, 15, 36, 3, 3, 4, 7, 8, 8;
  CHECK(largestError(curvaturesOf(fin).larger, 0) < 1e-9);
  // One side of a band has its faces turned over; folded and doubled faces.
  TriangleMesh strip = turned(tube(16, 8, 0.5, 1, true));
  for (Index f = 0; f < strip.faceCount() / 2; ++f) std::swap(strip.triangles(f, 0), strip.triangles(f, 1));
  const Curvatures turnedOver = curvaturesOf(strip);
  for (Index f = 0; f < strip.faceCount(); ++f) CHECK(turnedOver.strongest(f) == doctest::Approx(2).epsilon(0.02));
  TriangleMesh mess = moebiusStrip(20);
  mess.triangles.conservativeResize(mess.faceCount() + 2, 3);
  mess.triangles.bottomRows<2>() = mess.triangles.topRows<2>();
  mess.positions.row(5) = mess.positions.row(6);
  const Curvatures curvatures = curvaturesOf(mess);
  CHECK(curvatures.larger.allFinite());
  CHECK(curvatures.smaller.allFinite());
  CHECK(curvatures.direction.allFinite());
}

TEST_CASE("a hub of many faces takes no square of time, and its neighbours are as flat as it is") {
  const TriangleMesh disc = cylinder(6000, 1, 1, 1, 0.001, false);
  const Curvatures curvatures = curvaturesOf(disc);
  for (Index f = 12000; f < disc.faceCount(); ++f) CHECK(std::abs(curvatures.larger[f]) < 1e-9);
}
