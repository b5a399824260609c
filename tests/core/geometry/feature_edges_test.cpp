#include "geometry/feature_edges.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "support/shapes.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

constexpr double kDegree = EIGEN_PI / 180;

std::vector<FacePair> pairsOf(const TriangleMesh& mesh) {
  return facePairs(mesh.positions, mesh.triangles, MeshEdges(mesh.triangles, mesh.vertexCount()));
}

Index featureCount(const TriangleMesh& mesh, double degrees) {
  const MeshEdges edges(mesh.triangles, mesh.vertexCount());
  const auto features =
      featureEdges(facePairs(mesh.positions, mesh.triangles, edges), edges.count(), degrees * kDegree);
  REQUIRE(static_cast<Index>(features.size()) == edges.count());
  return static_cast<Index>(std::count(features.begin(), features.end(), true));
}

/// Faces around one line, the edge of vertices 0 and 1, at some degrees each.
TriangleMesh pages(const std::vector<double>& degrees) {
  const Index count = static_cast<Index>(degrees.size());
  TriangleMesh mesh{Points(2 + count, 3), Triangles(count, 3)};
  mesh.positions.topRows<2>() << 0, 0, 0, 0, 0, 1;
  for (Index f = 0; f < count; ++f) {
    mesh.positions.row(2 + f) << std::cos(degrees[f] * kDegree), std::sin(degrees[f] * kDegree), 0.5;
    mesh.triangles.row(f) << 0, 1, 2 + f;
  }
  return mesh;
}

}  // namespace

TEST_CASE("faces are paired once on each inner edge, with the angle between their normals") {
  const TriangleMesh box = longBox(3, 2);
  const auto pairs = pairsOf(box);
  CHECK(static_cast<Index>(pairs.size()) == box.faceCount() * 3 / 2);
  for (const FacePair& pair : pairs) {
    CHECK(pair.first < pair.second);
    CHECK((pair.angle == 0 || std::abs(pair.angle - EIGEN_PI / 2) < 1e-12));
  }
  CHECK(pairsOf(grid(4)).size() == 21);  // 33 edges, 12 of them at the border
}

TEST_CASE("the feature edges of a box are its twelve sides, of a smooth body none, of a prism those that bend more") {
  CHECK(featureCount(longBox(3, 2), 40) == 4 * 3 + 8 * 2);
  CHECK(featureCount(longBox(3, 2), 95) == 0);
  CHECK(featureCount(sphere(4), 40) == 0);
  CHECK(featureCount(grid(4), 40) == 0);
  CHECK(featureCount(prism(8, 0.3), 40) == 24);
  CHECK(featureCount(prism(8, 0.3), 46) == 16);
}

TEST_CASE("an angle is the same whichever sides of its faces are up") {
  TriangleMesh fold = pages({0, 150});  // both run the same way
  REQUIRE(pairsOf(fold).size() == 1);
  CHECK(pairsOf(fold)[0].angle == doctest::Approx(30 * kDegree));
  fold.triangles.row(1).reverseInPlace();
  CHECK(pairsOf(fold)[0].angle == doctest::Approx(30 * kDegree));
  CHECK(pairsOf(pages({0, 180}))[0].angle < 1e-12);
  CHECK(pairsOf(pages({0, 0}))[0].angle == doctest::Approx(EIGEN_PI));
}

TEST_CASE("an edge of many faces has all their pairs and is a feature below 60 degrees") {
  CHECK(pairsOf(pages({0, 120, 240})).size() == 3);
  CHECK(featureCount(pages({0, 120, 240}), 59) == 1);
  CHECK(featureCount(pages({0, 120, 240}), 61) == 0);
  std::vector<double> many(100);
  for (int i = 0; i < 100; ++i) many[i] = 3.6 * i;
  CHECK(pairsOf(pages(many)).size() == 100 * kMostFacesPaired - kMostFacesPaired * (kMostFacesPaired + 1) / 2);
}

TEST_CASE("a face without area bends nothing") {
  TriangleMesh fold = pages({0, 90});
  fold.positions.row(3) << 0, 0, 0.5;
  CHECK(pairsOf(fold)[0].angle == 0);
  fold.triangles.row(1).reverseInPlace();
  CHECK(pairsOf(fold)[0].angle == 0);
}
