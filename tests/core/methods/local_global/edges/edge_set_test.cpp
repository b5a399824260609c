#include "methods/local_global/edges/edge_set.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>

#include "support/rows.h"
#include "support/shapes.h"
#include "support/surface_measures.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

/// The energy by its definition: every element, every face around it, every edge of that.
double energyByDefinition(EdgeSetKind kind, const TriangleMesh& rest, const Points& output,
                          const std::vector<Mat3>& R) {
  const CornerScalars c = halfCotangents(rest.positions, rest.triangles);
  double energy = 0;
  for (Index f = 0; f < rest.faceCount(); ++f) {
    for (int k = 0; k < (kind == EdgeSetKind::faces ? 1 : 3); ++k) {
      const Mat3& Rk = R[kind == EdgeSetKind::faces ? f : rest.triangles(f, k)];
      for (int e = 0; e < 3; ++e) {
        const Index i = rest.triangles(f, (e + 1) % 3), j = rest.triangles(f, (e + 2) % 3);
        const Vec3 d = (rest.positions.row(j) - rest.positions.row(i)).transpose();
        const Vec3 u = (output.row(j) - output.row(i)).transpose();
        energy += c(f, e) * (Rk * d - u).squaredNorm();
      }
    }
  }
  return energy;
}

/// `n` faces around vertex 0, open, and one more on an edge that already has two.
TriangleMesh fan(int n) {
  TriangleMesh mesh{Points(n + 3, 3), Triangles(n + 1, 3)};
  mesh.positions.row(0).setZero();
  for (int k = 0; k <= n; ++k) {
    const double angle = 5.5 * k / n;
    mesh.positions.row(k + 1) << std::cos(angle), std::sin(angle), 0.2 * std::sin(3 * angle);
  }
  mesh.positions.row(n + 2) << 0.4, 0.3, 0.8;
  for (int k = 0; k < n; ++k) mesh.triangles.row(k) << 0, k + 1, k + 2;
  mesh.triangles.row(n) << 0, 3, n + 2;
  return mesh;
}

std::vector<QuaternionLanes> noisyRotations(Index count) {
  Noise noise;
  std::vector<QuaternionLanes> rotations(batchCount(count), identityRotations());
  for (Index k = 0; k < count; ++k) setRotation(rotations[k / 4], k % 4, noise.rotation());
  return rotations;
}

std::vector<Mat3> matricesOf(const std::vector<QuaternionLanes>& rotations, Index count) {
  std::vector<Mat3> matrices;
  for (Index k = 0; k < count; ++k) matrices.push_back(rotationAt(rotations[k / 4], k % 4));
  return matrices;
}

/// What a local step sees of an edge set with these rotations.
struct Looked {
  double energy = 0;
  std::vector<MatrixLanes> covariances;
  LaneRows residual;
};

/// @param size how many elements at a time
Looked look(const EdgeSet& edges, const LaneRows& displacements, const std::vector<QuaternionLanes>& rotations,
            Index size) {
  Looked result{0, std::vector<MatrixLanes>(rotations.size(), zeroMatrices()), LaneRows(displacements.size())};
  const StiffEdges& stiff = edges.stiffEdges();
  Points exact(stiff.vertices().size(), 3);
  for (Index place = 0; place < exact.rows(); ++place) {
    const LaneRow& row = displacements[stiff.vertices()[place]];
    exact.row(place) << row.x, row.y, row.z;
  }
  result.energy = edges.visits() * stiff.addForces(exact, result.residual);
  for (Index first = 0; first < edges.elementCount(); first += size) {
    const ElementRange range{first, std::min(first + size, edges.elementCount())};
    MatrixLanes* covariances = &result.covariances[range.firstBatch()];
    result.energy += edges.gatherCovariances(displacements, range, covariances, result.residual);
    std::vector<MatrixLanes> rotationChanges;
    for (std::size_t b = range.firstBatch(); b < range.endBatch(); ++b) {
      rotationChanges.push_back(rotationChange(rotations[b]));
      result.energy -=
          sumOf(toDouble(traceOfProduct(rotationChanges.back(), edges.restCovariances()[b] + result.covariances[b])));
    }
    edges.addRotationChanges(rotationChanges.data(), range, result.residual);
  }
  return result;
}

std::unique_ptr<EdgeSet> collected(EdgeSetKind kind, const TriangleMesh& rest, const CornerScalars& c) {
  auto edges = makeEdgeSet(kind, rest, c);
  while (edges->collectNext() < 1) {
  }
  return edges;
}

}  // namespace

TEST_CASE("both edge sets: covariances carry the energy, the global step is its gradient") {
  for (const EdgeSetKind kind : {EdgeSetKind::spokesAndRims, EdgeSetKind::faces}) {
    for (const TriangleMesh& rest : {bent(sphere(1)), bent(grid(4)), moebiusStrip(9), fan(40)}) {
      const CornerScalars c = halfCotangents(rest.positions, rest.triangles);
      const auto edges = collected(kind, rest, c);
      const std::vector<QuaternionLanes> rotations = noisyRotations(edges->elementCount());
      const std::vector<Mat3> R = matricesOf(rotations, edges->elementCount());
      const LaneRows displacements = toRows(bent(rest).positions - rest.positions);
      const Points output = rest.positions + toPoints(displacements, rest.vertexCount());

      const Looked here = look(*edges, displacements, rotations, edges->elementCount());
      CHECK(here.energy == doctest::Approx(energyByDefinition(kind, rest, output, R)).epsilon(1e-6));

      const double visits = edges->visits();
      const double h = 1e-5;
      for (Index v = 0; v < rest.vertexCount(); v += 5) {
        const float components[] = {here.residual[v].x, here.residual[v].y, here.residual[v].z};
        for (int axis = 0; axis < 3; ++axis) {
          Points plus = output, minus = output;
          plus(v, axis) += h;
          minus(v, axis) -= h;
          const double slope =
              (energyByDefinition(kind, rest, plus, R) - energyByDefinition(kind, rest, minus, R)) / (2 * h);
          CHECK(std::abs(-2 * visits * components[axis] - slope) < 1e-5);
        }
      }
      // The Hessian is the Laplacian: the residual changes by −L ΔV.
      const Looked atRest = look(*edges, LaneRows(displacements.size()), rotations, edges->elementCount());
      const Points change = denseLaplacian(rest) * (output - rest.positions);
      CHECK((toPoints(here.residual, rest.vertexCount()) - toPoints(atRest.residual, rest.vertexCount()) + change)
                .norm() < 1e-5);
    }
  }
}

TEST_CASE("what thin faces say is not lost on the others") {
  TriangleMesh rest = bent(grid(4));
  // A vertex next to the edge across from it: caps whose weights are some hundreds and cancel.
  const auto corners = rest.triangles.row(9);
  const Eigen::RowVector3d a = rest.positions.row(corners[0]), b = rest.positions.row(corners[1]),
                           c0 = rest.positions.row(corners[2]);
  rest.positions.row(corners[2]) = 0.499 * (a + b) + 0.002 * c0;
  const CornerScalars c = halfCotangents(rest.positions, rest.triangles);
  for (const EdgeSetKind kind : {EdgeSetKind::spokesAndRims, EdgeSetKind::faces}) {
    const auto edges = collected(kind, rest, c);
    const Index n = rest.vertexCount();
    REQUIRE(!edges->stiffEdges().vertices().empty());
    CHECK(static_cast<Index>(edges->stiffEdges().vertices().size()) < n);
    const std::vector<QuaternionLanes> rotations = noisyRotations(edges->elementCount());
    const std::vector<Mat3> R = matricesOf(rotations, edges->elementCount());
    const LaneRows displacements = toRows(bent(rest).positions - rest.positions);
    const Points output = rest.positions + toPoints(displacements, n);
    const Looked here = look(*edges, displacements, rotations, edges->elementCount());
    CHECK(here.energy == doctest::Approx(energyByDefinition(kind, rest, output, R)).epsilon(1e-6));
    // −L δ as it is in double precision; what the rotations add is the same at rest.
    const Looked atRest = look(*edges, LaneRows(displacements.size()), rotations, edges->elementCount());
    const Points forces = -denseLaplacian(rest) * (output - rest.positions);
    const Points found = toPoints(here.residual, n) - toPoints(atRest.residual, n);
    for (Index v = 0; v < n; ++v) CHECK((found.row(v) - forces.row(v)).norm() < 1e-5 * (1 + forces.row(v).norm()));
  }
}

TEST_CASE("ranges of elements add up to all of them") {
  for (const EdgeSetKind kind : {EdgeSetKind::spokesAndRims, EdgeSetKind::faces}) {
    const TriangleMesh rest = bent(grid(4));
    const CornerScalars c = halfCotangents(rest.positions, rest.triangles);
    const auto edges = collected(kind, rest, c);
    const std::vector<QuaternionLanes> rotations = noisyRotations(edges->elementCount());
    const LaneRows displacements = toRows(bent(rest).positions - rest.positions);
    const Looked whole = look(*edges, displacements, rotations, edges->elementCount());
    const Looked pieces = look(*edges, displacements, rotations, 8);
    CHECK(pieces.energy == doctest::Approx(whole.energy).epsilon(1e-12));
    CHECK(std::memcmp(whole.covariances.data(), pieces.covariances.data(),
                      whole.covariances.size() * sizeof(MatrixLanes)) == 0);
    const Index n = rest.vertexCount();
    CHECK((toPoints(whole.residual, n) - toPoints(pieces.residual, n)).cwiseAbs().maxCoeff() < 1e-6);
  }
}

TEST_CASE("the rest shape has no energy and asks for nothing, to the bit") {
  for (const EdgeSetKind kind : {EdgeSetKind::spokesAndRims, EdgeSetKind::faces}) {
    for (const TriangleMesh& rest : {bent(sphere(2)), moebiusStrip(9), fan(200)}) {
      const CornerScalars c = halfCotangents(rest.positions, rest.triangles);
      const auto edges = collected(kind, rest, c);
      const std::vector<QuaternionLanes> identity(batchCount(edges->elementCount()), identityRotations());
      const Looked atRest = look(*edges, toRows(Points::Zero(rest.vertexCount(), 3)), identity, edges->elementCount());
      CHECK(atRest.energy == 0);
      CHECK(toPoints(atRest.residual, rest.vertexCount()).isZero(0));
    }
  }
}

TEST_CASE("what fills up the last batch adds nothing to any vertex") {
  for (const EdgeSetKind kind : {EdgeSetKind::spokesAndRims, EdgeSetKind::faces}) {
    const TriangleMesh rest = fan(8);  // 11 vertices and 9 faces
    const CornerScalars c = halfCotangents(rest.positions, rest.triangles);
    const auto edges = collected(kind, rest, c);
    const Index count = edges->elementCount();
    std::vector<QuaternionLanes> rotations = noisyRotations(count), other = rotations;
    for (Index k = count; k < 4 * static_cast<Index>(other.size()); ++k)
      setRotation(other[k / 4], k % 4, Noise().rotation());
    const LaneRows displacements = toRows(bent(rest).positions - rest.positions);
    const Looked one = look(*edges, displacements, rotations, count), two = look(*edges, displacements, other, count);
    CHECK(one.energy == two.energy);
    CHECK(toPoints(one.residual, rest.vertexCount()) == toPoints(two.residual, rest.vertexCount()));
  }
}
