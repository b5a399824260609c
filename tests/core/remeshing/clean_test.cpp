#include "remeshing/clean.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <utility>

#include "geometry/surface.h"
#include "mesh/adjacency.h"
#include "mesh/validate.h"
#include "support/shapes.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

EdgeCounts edgesOf(const TriangleMesh& mesh) {
  return countEdges(mesh.triangles, Fans(mesh.triangles, mesh.vertexCount()));
}

double volume(const TriangleMesh& mesh) {
  double sum = 0;
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    const auto corner = [&](int k) -> Vec3 { return mesh.positions.row(mesh.triangles(f, k)).transpose(); };
    sum += corner(0).dot(corner(1).cross(corner(2))) / 6;
  }
  return sum;
}

/// The mesh with a vertex on the side from corner k to k + 1 of a face, a share of the way along and `off` to the side,
/// known to that face alone: a sliver fills what is between it and the face beyond.
TriangleMesh withSliver(TriangleMesh mesh, Index face, int k, double along, double off) {
  const Index a = mesh.triangles(face, k), b = mesh.triangles(face, (k + 1) % 3), c = mesh.triangles(face, (k + 2) % 3);
  const Index v = mesh.vertexCount(), count = mesh.faceCount();
  mesh.positions.conservativeResize(v + 1, 3);
  mesh.positions.row(v) = (1 - along) * mesh.positions.row(a) + along * mesh.positions.row(b);
  mesh.positions.row(v) += off * (mesh.positions.row(c) - mesh.positions.row(v));
  mesh.triangles.conservativeResize(count + 2, 3);
  mesh.triangles.row(face) << a, v, c;
  mesh.triangles.row(count) << v, b, c;
  mesh.triangles.row(count + 1) << a, b, v;
  return mesh;
}

void checkClean(const TriangleMesh& mesh) {
  const CleanMesh cleaned = clean(mesh);
  CHECK(cleaned.unmended.empty());
  const TriangleMesh& result = cleaned.derived.mesh;
  for (Index f = 0; f < result.faceCount(); ++f) CHECK(thickness(result, f) >= kSliver);
  for (Index v = 0; v < result.vertexCount(); ++v) {
    REQUIRE(cleaned.derived.vertexOrigin[v] >= 0);
    CHECK(result.positions.row(v) == mesh.positions.row(cleaned.derived.vertexOrigin[v]));
  }
  const CleanMesh again = clean(mesh);
  CHECK(again.derived.mesh.triangles == result.triangles);
  CHECK(clean(result).mended == 0);
}

TriangleMesh box(double x, double y, double z) {
  TriangleMesh mesh = longBox(1, 1);
  mesh.positions *= Vec3(x, y, z).asDiagonal();
  return mesh;
}

}  // namespace

TEST_CASE("a mesh without slivers comes back as it is") {
  TriangleMesh odd = grid(5);
  odd.positions.conservativeResize(26, 3);  // a vertex without a face stays
  for (const TriangleMesh& mesh : {bent(torus(20)), box(1, 1, 1), box(1, .3, .01), moebiusStrip(30), odd}) {
    const CleanMesh cleaned = clean(mesh);
    CHECK(cleaned.mended == 0);
    CHECK(cleaned.unmended.empty());
    CHECK(cleaned.derived.mesh.positions == mesh.positions);
    CHECK(cleaned.derived.mesh.triangles == mesh.triangles);
    CHECK(cleaned.derived.vertexOrigin[mesh.vertexCount() - 1] == mesh.vertexCount() - 1);
  }
}

TEST_CASE("caps are cut away wherever their vertex is, and nothing opens") {
  for (const double along : {0.5, 0.2, 0.03}) {
    for (const double off : {0.0, 1e-9, 1e-5, 3e-4}) {
      for (Index face = 0; face < 12; ++face) {
        for (int k = 0; k < 3; ++k) {
          CAPTURE(along);
          CAPTURE(off);
          CAPTURE(face);
          const TriangleMesh mesh = withSliver(box(1, .8, .6), face, k, along, off);
          checkClean(mesh);
          const TriangleMesh cleaned = clean(mesh).derived.mesh;
          CHECK(edgesOf(cleaned).boundary == 0);
          CHECK(volume(cleaned) == doctest::Approx(.48).epsilon(1e-3));
        }
      }
    }
  }
}

TEST_CASE("needles are collapsed, on creases along them") {
  for (const double along : {1e-4, 1e-7, 1 - 1e-4}) {
    for (Index face = 0; face < 12; ++face) {
      for (int k = 0; k < 3; ++k) {
        CAPTURE(face);
        TriangleMesh mesh = withSliver(box(1, .8, .6), face, k, along, 0);
        // Put into the face beyond as well: a needle on both sides of the edge.
        mesh = clean(mesh).derived.mesh;
        checkClean(mesh);
        CHECK(edgesOf(clean(mesh).derived.mesh).boundary == 0);
        CHECK(volume(clean(mesh).derived.mesh) == doctest::Approx(.48).epsilon(1e-3));
      }
    }
  }
}

TEST_CASE("a chain of slivers goes") {
  TriangleMesh mesh = bent(grid(6));
  Noise noise;
  for (int i = 0; i < 40; ++i) {
    const double along = 0.5 + 0.3 * noise(), off = 2e-4 * std::abs(noise());
    mesh = withSliver(mesh, (7 * i) % mesh.faceCount(), i % 3, along, off);
  }
  const double area = faceAreas(mesh.positions, mesh.triangles).sum();
  checkClean(mesh);
  const TriangleMesh cleaned = clean(mesh).derived.mesh;
  CHECK(faceAreas(cleaned.positions, cleaned.triangles).sum() == doctest::Approx(area).epsilon(2e-3));
  CHECK(connectedComponents(cleaned.triangles, cleaned.vertexCount()).count == 1);
}

TEST_CASE("the sides of a thin wall are not put together, and what cannot be mended is said") {
  const TriangleMesh plate = box(1, .8, 5e-4);  // walls of slivers, each of which a wall needs
  const CleanMesh cleaned = clean(plate);
  CHECK(cleaned.mended == 0);
  CHECK(cleaned.unmended.size() == 8);
  CHECK(cleaned.derived.mesh.triangles == plate.triangles);
}

TEST_CASE("doubled faces, faces that use a vertex twice and seams of many faces") {
  TriangleMesh mesh = bent(grid(5));
  const Index count = mesh.faceCount(), v = mesh.vertexCount();
  mesh.positions.conservativeResize(v + 1, 3);
  mesh.positions.row(v) << 0.4, 0.4, 0.9;
  mesh.triangles.conservativeResize(count + 5, 3);
  mesh.triangles.row(count) = mesh.triangles.row(3);
  mesh.triangles.row(count + 1) = mesh.triangles.row(9).reverse();
  mesh.triangles.row(count + 2) << 4, 4, 9;
  mesh.triangles.row(count + 3) << 7, 7, 7;
  mesh.triangles.row(count + 4) << 6, 12, v;  // stands on the edge between two faces
  TriangleMesh sliver = withSliver(mesh, count + 4, 0, 0.4, 1e-5);
  checkClean(sliver);
  const CleanMesh cleaned = clean(sliver);
  CHECK(edgesOf(cleaned.derived.mesh).nonManifold == 2);  // the seam, in two pieces now
  CHECK(cleaned.mended == 5);
  CHECK(cleaned.derived.mesh.faceCount() == count + 4);
}

TEST_CASE("flipped faces are mended as they stand, and parts in one place stay apart") {
  TriangleMesh mesh = withSliver(box(1, 1, 1), 3, 0, 0.4, 1e-5);
  for (Index f = 0; f < mesh.faceCount(); f += 3) mesh.triangles.row(f).reverseInPlace();
  checkClean(mesh);
  const TriangleMesh two = together(mesh, mesh, Vec3::Zero());
  checkClean(two);
  const TriangleMesh cleaned = clean(two).derived.mesh;
  CHECK(connectedComponents(cleaned.triangles, cleaned.vertexCount()).count == 2);
  CHECK(cleaned.faceCount() == 2 * clean(mesh).derived.mesh.faceCount());
}

TEST_CASE("what has nothing left to mend it by loses its faces without area at least") {
  Noise noise;
  for (const double step : {0.4, 0.1, 0.06}) {
    CAPTURE(step);
    TriangleMesh mesh = together(animal(4), moebiusStrip(80), {0.2, 0, 0});
    mesh.positions = step * (mesh.positions / step).array().round().matrix();  // many places coincide
    for (int i = 0; i < 200; ++i) {
      const Index corner = static_cast<Index>((0.5 + 0.5 * noise()) * (mesh.triangles.size() - 1));
      mesh.triangles.data()[corner] = static_cast<Index>((0.5 + 0.5 * noise()) * (mesh.vertexCount() - 1));
    }
    const CleanMesh cleaned = clean(mesh);
    REQUIRE(validate(cleaned.derived.mesh).ok());
    CHECK(cleaned.mended > 0);
    CHECK(cleaned.unmended.size() < 0.01 * cleaned.derived.mesh.faceCount());
    CHECK(inspect(cleaned.derived.mesh).degenerateFaces == 0);
  }
}
