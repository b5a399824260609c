#include "methods/alternating/cylinder_patches.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "support/round_shapes.h"
#include "support/shapes.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

std::vector<CylinderPatch> patchesOf(const TriangleMesh& mesh) {
  const MeshEdges edges(mesh.triangles, mesh.vertexCount());
  const auto pairs = facePairs(mesh.positions, mesh.triangles, edges);
  const auto features = featureEdges(pairs, edges.count(), 40 * EIGEN_PI / 180);
  CurvatureEstimate estimate(mesh.positions, mesh.triangles, edges, features);
  while (estimate.next() < 1) {
  }
  return cylinderPatches(mesh, pairs, features, estimate.take());
}

/// Handles on vertices at a height, each moved by what `move` says of its place.
template <typename Choose, typename Move>
Handles handlesOn(const TriangleMesh& mesh, Choose choose, Move move) {
  Handles handles;
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    if (choose(Vec3(mesh.positions.row(v)))) handles.vertices.push_back(v);
  }
  handles.targets.resize(static_cast<Index>(handles.vertices.size()), 3);
  for (Index i = 0; i < handles.targets.rows(); ++i) {
    const Vec3 place = mesh.positions.row(handles.vertices[i]);
    handles.targets.row(i) = (place + move(place)).transpose();
  }
  return handles;
}

bool isLow(const Vec3& place) { return place[2] < 1e-9; }
/// Away from the z axis.
Vec3 widening(const Vec3& place) { return 0.1 * Vec3(place[0], place[1], 0); }

/// A tube within a tube, as two open walls around z.
TriangleMesh walls(double inner, double outer, const Vec3& offset) {
  return together(tube(20, 6, outer, 1, true), tube(20, 6, inner, 1, true), offset);
}

}  // namespace

TEST_CASE("a closed cylinder, a hole and a fillet are patches with their axis and radius") {
  for (const int sides : {10, 32}) {
    const TriangleMesh rod = turned(cylinder(sides, 8, 2, 0.2, 0.9, true));
    const auto patches = patchesOf(rod);
    REQUIRE(patches.size() == 1);
    const CylinderPatch& patch = patches[0];
    CHECK(static_cast<int>(patch.faces.size()) == 2 * sides * 8);
    CHECK(patch.radius == doctest::Approx(0.2).epsilon(1e-6));
    CHECK(patch.axis.cross(someRotation().col(2)).norm() < 1e-3);
    CHECK(patch.point.cross(someRotation().col(2)).norm() < 1e-3);
  }
  const auto hole = patchesOf(turned(tube(10, 1, 0.05, 0.04, false)));
  REQUIRE(hole.size() == 1);
  CHECK(hole[0].faces.size() == 20);
  const auto fillet = patchesOf(turned(sheet(
      {4, 6}, [](double u, double v) { return Vec3(0.1 * std::cos(u * 1.57), 0.1 * std::sin(u * 1.57), 0.5 * v); })));
  REQUIRE(fillet.size() == 1);
  CHECK(fillet[0].radius == doctest::Approx(0.1).epsilon(1e-6));
}

TEST_CASE("flat sides beside a fillet are none of it, however coarse the mesh") {
  constexpr int kRows = 6;
  for (const int steps : {4, 8}) {
    // A quarter of a circle of radius 0.1 between two sides of length 0.3.
    const auto profile = [&](double u) {
      const double along = 3 * steps * u - steps;
      const double angle = std::clamp(along / steps, 0.0, 1.0) * EIGEN_PI / 2, past = 0.3 / steps;
      const Vec3 arc(0.1 * std::cos(angle), 0.1 * std::sin(angle), 0);
      return Vec3(arc + past * Vec3(-std::max(along - steps, 0.0), std::min(along, 0.0), 0));
    };
    const auto patches = patchesOf(
        turned(sheet({3 * steps, kRows}, [&](double u, double v) { return Vec3(profile(u) + Vec3(0, 0, 0.5 * v)); })));
    REQUIRE(patches.size() == 1);
    CHECK(static_cast<int>(patches[0].faces.size()) == 2 * steps * kRows);
    CHECK(patches[0].radius == doctest::Approx(0.1).epsilon(1e-6));
  }
}

TEST_CASE("spheres, planes, boxes, cones, bends and what is large or oval are no patches") {
  CHECK(patchesOf(sphere(3)).empty());
  CHECK(patchesOf(grid(9)).empty());
  CHECK(patchesOf(longBox(4, 3)).empty());
  CHECK(patchesOf(tube(200, 8, 1.1, 0.3, true)).empty());
  const auto ring = [](double width, double slope, double oval) {
    return sheet({32, 8, true, false, true}, [=](double u, double v) {
      const double angle = 2 * EIGEN_PI * u, r = width + slope * v;
      return Vec3(r * std::cos(angle), oval * r * std::sin(angle), v);
    });
  };
  CHECK(patchesOf(ring(0.3, 0.01, 1)).size() == 1);
  CHECK(patchesOf(ring(0.2, 0.2, 1)).empty());
  CHECK(patchesOf(ring(0.3, 0, 1.02)).size() == 1);
  CHECK(patchesOf(ring(0.3, 0, 1.2)).empty());
  CHECK(patchesOf(turned(torus(40))).empty());
}

TEST_CASE("a few faces are no patch, and one odd vertex loses none") {
  CHECK(patchesOf(sheet({1, 3}, [](double u, double v) {
          return Vec3(0.2 * std::sin(v), u, 0.2 * std::cos(v));
        })).empty());
  TriangleMesh peg = tube(20, 6, 0.2, 1, true);
  peg.positions(50, 2) += 0.02;
  peg.positions.row(50).head<2>() *= 1.06;
  CHECK(patchesOf(peg).size() == 1);
}

TEST_CASE("a patch keeps its radius when its handles move as one across the axis or anyhow along it") {
  const TriangleMesh mesh = tube(20, 6, 0.2, 1, true);
  const auto patches = patchesOf(mesh);
  REQUIRE(patches.size() == 1);
  const auto kept = [&](auto move) -> bool { return keptPatches(patches, mesh, handlesOn(mesh, isLow, move))[0]; };
  CHECK(keptPatches(patches, mesh, {})[0]);
  CHECK(kept([](const Vec3&) -> Vec3 { return {0.3, 0.1, -1}; }));
  CHECK(kept([](const Vec3& place) -> Vec3 { return {0, 0, place[0]}; }));
  CHECK(!kept(widening));
  CHECK(kept([](const Vec3& place) -> Vec3 { return 0.02 * widening(place); }));
  CHECK(!kept([](const Vec3& place) -> Vec3 { return 0.03 * widening(place); }));
  // Handles of others say nothing.
  const TriangleMesh two = together(mesh, mesh, {3, 0, 0});
  const auto far = handlesOn(
      two, [](const Vec3& place) { return place[0] > 1; }, widening);
  CHECK(keptPatches(patchesOf(two), two, far) == std::vector<bool>{true, false});
}

TEST_CASE("a wall is widened as one, step by step, but a rod within a disc is not") {
  const auto keptIn = [](const TriangleMesh& mesh, double atRadius) {
    const auto patches = patchesOf(mesh);
    const auto isThere = [&](const Vec3& place) {
      return isLow(place) && std::abs(place.head<2>().norm() - atRadius) < 0.01;
    };
    return keptPatches(patches, mesh, handlesOn(mesh, isThere, widening));
  };
  CHECK(keptIn(walls(0.32, 0.4, Vec3::Zero()), 0.4) == std::vector<bool>{false, false});
  CHECK(keptIn(walls(0.32, 0.4, Vec3::Zero()), 0.32) == std::vector<bool>{false, false});
  CHECK(keptIn(walls(0.2, 0.4, Vec3::Zero()), 0.4) == std::vector<bool>{false, true});
  CHECK(keptIn(walls(0.32, 0.4, {0.03, 0, 0}), 0.4) == std::vector<bool>{false, true});
  const TriangleMesh nested = together(walls(0.26, 0.33, Vec3::Zero()), tube(20, 6, 0.42, 1, true), Vec3::Zero());
  CHECK(keptIn(nested, 0.42) == std::vector<bool>{false, false, false});
  TriangleMesh tilted = tube(20, 6, 0.32, 1, true);
  tilted.positions = (tilted.positions * Eigen::AngleAxisd(0.05, Vec3::UnitX()).matrix().transpose()).eval();
  CHECK(keptIn(together(tube(20, 6, 0.4, 1, true), tilted, Vec3::Zero()), 0.4) == std::vector<bool>{false, true});
}
