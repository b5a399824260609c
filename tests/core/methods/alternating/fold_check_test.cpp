#include "methods/alternating/fold_check.h"

#include <doctest/doctest.h>

#include <cmath>

#include "support/shapes.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

/// A square of four faces, one of them a sliver along a line across it, and the same square in even faces.
struct Square {
  TriangleMesh input;
  DerivedMesh even;

  Square() {
    even.mesh = grid(16);
    even.vertexOrigin.assign(even.mesh.vertexCount(), -1);
    even.faceOrigin.assign(even.mesh.faceCount(), 0);
    const Points& places = even.mesh.positions;
    const Eigen::RowVector3d low = places.colwise().minCoeff(), size = places.colwise().maxCoeff() - low;
    input.positions.resize(5, 3);
    input.positions << 0, 0.5, 0, 1, 0.5, 0, 0.5, 0.501, 0, 0.5, 1, 0, 0.5, 0, 0;
    for (Index v = 0; v < 5; ++v) input.positions.row(v) = low + input.positions.row(v).cwiseProduct(size);
    input.triangles.resize(4, 3);
    input.triangles << 0, 1, 2, 2, 1, 3, 0, 2, 3, 1, 0, 4;
  }

  /// How many faces of the input turn over in their plane as the even ones are moved by `move`.
  template <typename Move>
  Index turned(Move move) const {
    Transfer transfer(input, even);
    while (transfer.next() < 1) {
    }
    const RestSurface surface = measureSurface(even.mesh);
    Points moved = even.mesh.positions, carried = input.positions;
    for (Index v = 0; v < moved.rows(); ++v) moved.row(v) += move(Vec3(moved.row(v).transpose())).transpose();
    transfer.carry(moved, carried);
    return turnedInPlane(input, carried, {surface, moved, transfer});
  }
};

}  // namespace

TEST_CASE("a sliver whose corners are carried past each other in a flat side is counted") {
  const Square square;
  const Vec3 size =
      (square.even.mesh.positions.colwise().maxCoeff() - square.even.mesh.positions.colwise().minCoeff()).transpose();
  const Vec3 middle = square.input.positions.row(2).transpose();
  // The middle of the line is moved against its ends.
  const auto bulge = [&](const Vec3& p) { return std::exp(-10 * ((p - middle) / size.x()).squaredNorm()); };
  CHECK(square.turned([](const Vec3&) -> Vec3 { return Vec3::Zero(); }) == 0);
  CHECK(square.turned([](const Vec3&) -> Vec3 { return Vec3(1, 2, 3); }) == 0);
  CHECK(square.turned([&](const Vec3& p) -> Vec3 { return -0.05 * size.y() * bulge(p) * Vec3::UnitY(); }) == 1);
  CHECK(square.turned([&](const Vec3& p) -> Vec3 { return 0.05 * size.y() * bulge(p) * Vec3::UnitY(); }) == 0);
  // A dent across the plane tilts the sliver, which is no turn within a flat side.
  CHECK(square.turned([&](const Vec3& p) -> Vec3 { return 0.3 * size.y() * bulge(p) * Vec3::UnitZ(); }) == 0);
  // Where the even faces fold themselves, that is told of.
  CHECK(square.turned([&](const Vec3& p) -> Vec3 { return -1.5 * size.y() * bulge(p) * Vec3::UnitY(); }) == 0);
}

TEST_CASE("faces that fold are counted, and make a result unclean where they are large enough to be seen") {
  const TriangleMesh plane = grid(8);
  for (const double size : {1e-4, 0.5}) {
    // A triangle of this size beside the plane is turned over.
    TriangleMesh one;
    one.positions.resize(3, 3);
    one.positions << 0, 0, 0, size, 0, 0, 0, size, 0;
    one.triangles.resize(1, 3);
    one.triangles << 0, 1, 2;
    const RestSurface surface = measureSurface(together(plane, one, Vec3(5, 0, 0)));
    Points folded = surface.mesh.positions;
    folded.row(surface.vertexCount() - 2).swap(folded.row(surface.vertexCount() - 1));
    CHECK(findFolds(surface, surface.mesh.positions).isClean());
    const FoldReport report = findFolds(surface, folded);
    CHECK(report.flipped == 1);
    CHECK(report.steep == 1);
    CHECK(report.isClean() == (size < 0.01));
  }
}
