#include "remeshing/transfer.h"

#include <doctest/doctest.h>

#include <cstring>
#include <utility>
#include <vector>

#include "support/allocations.h"
#include "support/shapes.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

/// A working mesh whose faces lie on those of an original as `faceOrigin` says, with no vertex in common.
DerivedMesh made(const TriangleMesh& mesh, std::vector<Index> faceOrigin) {
  return {mesh, std::vector<Index>(mesh.vertexCount(), -1), std::move(faceOrigin)};
}

Transfer found(const TriangleMesh& input, const DerivedMesh& working) {
  Transfer transfer(input, working);
  while (transfer.next() < 1) {
  }
  return transfer;
}

bool sameBits(const Points& one, const Points& other) {
  return one.size() == other.size() && std::memcmp(one.data(), other.data(), sizeof(double) * one.size()) == 0;
}

}  // namespace

TEST_CASE("rest is carried to rest, to the bit, and an affine move of the working mesh to the input's vertices") {
  const TriangleMesh input = bent(torus(40));
  const DerivedMesh working = made(bent(torus(23)), std::vector<Index>(2 * 23 * 23, 0));
  const Transfer transfer = found(input, working);
  Points carried = Points::Zero(input.vertexCount(), 3);
  transfer.carry(working.mesh.positions, carried);
  CHECK(sameBits(carried, input.positions));

  const Vec3 move(0.3, -0.2, 0.1);
  const Points moved = working.mesh.positions.rowwise() + move.transpose();
  const long before = allocationCount();
  transfer.carry(moved, carried);
  CHECK(allocationCount() == before);
  CHECK((carried - (input.positions.rowwise() + move.transpose())).cwiseAbs().maxCoeff() < 1e-14);
  // Stretching moves a vertex as it does the nearest point, which is never farther away than an edge is long.
  transfer.carry(2 * working.mesh.positions, carried);
  CHECK((carried - 2 * input.positions).rowwise().norm().maxCoeff() < 0.05);
}

TEST_CASE("vertices that the working mesh has in the same place take the very place of their twins") {
  const TriangleMesh input = bent(sphere(3));
  DerivedMesh working = DerivedMesh::same(input);
  working.mesh.positions(7, 0) += 0.01;  // not in the same place any more
  const Transfer transfer = found(input, working);
  Points moved = working.mesh.positions;
  Noise noise;
  for (Index i = 0; i < moved.size(); ++i) moved.data()[i] += 0.3 * noise();
  Points carried(input.vertexCount(), 3);
  transfer.carry(moved, carried);
  CHECK(transfer.place(7).twin == -1);
  CHECK(transfer.place(7).face >= 0);
  carried.row(7) = moved.row(7);
  CHECK(sameBits(carried, moved));
}

TEST_CASE("the two sides of a thin plate and parts that touch are not taken for each other") {
  // A plate, its lower side turned over, and a second one that lies on it; the working mesh is shifted across by more
  // than what is between them.
  const TriangleMesh top = grid(12);
  TriangleMesh bottom = top;
  bottom.triangles.col(1).swap(bottom.triangles.col(2));
  const double thin = 1e-3;
  const TriangleMesh input = together(together(top, bottom, {0, 0, -thin}), top, {0, 0, 1e-5});
  const TriangleMesh coarse = grid(7);
  TriangleMesh coarseBottom = coarse;
  coarseBottom.triangles.col(1).swap(coarseBottom.triangles.col(2));
  const TriangleMesh shifted = together(together(coarse, coarseBottom, {0, 0, -thin}), coarse, {0, 0, 1e-5});
  std::vector<Index> origins(shifted.faceCount());
  for (Index f = 0; f < shifted.faceCount(); ++f) origins[f] = f / coarse.faceCount() * top.faceCount();
  DerivedMesh working = made(shifted, origins);
  working.mesh.positions.col(2).array() += 0.8 * thin;
  const Transfer transfer = found(input, working);
  for (Index v = 0; v < input.vertexCount(); ++v) {
    CAPTURE(v);
    CHECK(transfer.place(v).face / coarse.faceCount() == v / top.vertexCount());
  }
}

TEST_CASE("vertices without a face stay, those of faces without area follow the nearest") {
  TriangleMesh input = grid(4);
  input.positions.conservativeResize(20, 3);
  input.positions.bottomRows<4>() << 9, 9, 9, 0.5, 0.5, 0, 0.6, 0.5, 0, 0.7, 0.5, 0;
  const Index count = input.faceCount();
  input.triangles.conservativeResize(count + 1, 3);
  input.triangles.row(count) << 17, 18, 19;
  const DerivedMesh working = made(grid(3), std::vector<Index>(8, 0));
  const Transfer transfer = found(input, working);
  Points carried(20, 3);
  transfer.carry(working.mesh.positions.rowwise() + Eigen::RowVector3d(0, 0, 1), carried);
  CHECK(carried(16, 2) == 9);
  CHECK(carried(18, 2) == doctest::Approx(1));
}

TEST_CASE("a derived mesh of a derived mesh knows the first original") {
  const TriangleMesh mesh = grid(3);
  const DerivedMesh first{mesh, {-1, 4, 5, 6, 7, 8, 9, 10, 11}, {9, 8, 7, 6, 5, 4, 3, 2}};
  const DerivedMesh second = first.then({mesh, {0, 1, -1, 3, 4, 5, 6, 7, 8}, {1, 1, 2, 3, 4, 5, 6, 7}});
  CHECK(second.vertexOrigin == std::vector<Index>{-1, 4, -1, 6, 7, 8, 9, 10, 11});
  CHECK(second.faceOrigin == std::vector<Index>{8, 8, 7, 6, 5, 4, 3, 2});
}
