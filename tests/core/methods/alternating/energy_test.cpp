#include <doctest/doctest.h>

#include <cmath>

#include "methods/alternating/alternation.h"
#include "methods/alternating/reshape_terms.h"
#include "support/round_shapes.h"
#include "support/shapes.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

/// A surface with all terms at work: a bent torus, part of it sphere, part cylinder.
RestSurface someSurface() {
  TriangleMesh mesh = bent(torus(10));
  mesh.positions *= 0.4;
  RestSurface surface = measureSurface(std::move(mesh));
  setEdgeNormals(surface, 1.1);
  for (Index f = 0; f < surface.faceCount(); ++f) {
    surface.sphericity[f] = f % 3 == 0 ? 0.7 : 0;
    if (f % 3 == 1) surface.keptDirections.row(f) = surface.halfEdges.row(3 * f).normalized();
  }
  return surface;
}

Transformations someTransformations(Index faces, Noise& noise) {
  Transformations result;
  for (Index f = 0; f < faces; ++f) result.push_back(Mat3::Identity() + 0.2 * noise.matrix());
  return result;
}

Points bentPositions(const RestSurface& surface) {
  Points positions = surface.mesh.positions;
  for (Index v = 0; v < positions.rows(); ++v) positions(v, 2) += 0.3 * positions(v, 0) * positions(v, 0);
  return positions;
}

/// The term that ties transformations to half edges, which `energy` leaves out.
double transformTerm(const RestSurface& surface, const Points& halfEdges, const Transformations& tau) {
  double energy = 0;
  for (Index h = 0; h < surface.halfEdgeCount(); ++h) {
    energy += (halfEdges.row(h).transpose() - tau[faceOf(h)] * surface.halfEdges.row(h).transpose()).squaredNorm() /
              surface.averageLength;
  }
  return energy;
}

}  // namespace

TEST_CASE("the transformation solve ends where its energy has no slope") {
  const RestSurface surface = someSurface();
  Points halfEdges(surface.halfEdgeCount(), 3);
  halfEdgeVectors(bentPositions(surface), surface.mesh.triangles, halfEdges);
  const EnergyWeights weights;
  TransformationSystem system;
  system.shape(surface, weights);
  for (double share = 0; share < 1;) REQUIRE(system.prepareNext(share).ok());
  Noise noise;
  Transformations tau(surface.faceCount(), Mat3::Identity());
  for (int round = 0; round < 3; ++round) {
    system.beginSolve(halfEdges, {1e-7, 2000}, tau);
    while (!system.solveNext()) {
    }
  }
  const auto energyAt = [&](double step, const Transformations& direction) {
    Transformations moved = tau;
    for (Index f = 0; f < surface.faceCount(); ++f) moved[f] += step * (direction[f] - Mat3::Identity());
    return system.energy(moved) + transformTerm(surface, halfEdges, moved);
  };
  for (int trial = 0; trial < 5; ++trial) {
    const Transformations direction = someTransformations(surface.faceCount(), noise);
    const double up = energyAt(1e-3, direction), at = energyAt(0, direction), down = energyAt(-1e-3, direction);
    CHECK(up > at);
    CHECK(down > at);
    CHECK(std::abs(up - down) < 1e-3 * (up + down - 2 * at));
  }
}

TEST_CASE("the vertex solve ends where its energy has no slope") {
  const RestSurface surface = someSurface();
  Noise noise;
  const Transformations tau = someTransformations(surface.faceCount(), noise);
  const EnergyWeights weights;
  EdgeGoals goals = restGoals(surface);
  for (Index h = 0; h < surface.halfEdgeCount(); ++h) goals.stress[h] = 1 + std::abs(noise());
  std::vector<PointRow> rows(2);
  rows[0].stiffness = 1e3;
  rows[0].add(3, 1);
  rows[0].target = Vec3(0.1, 0.2, 0.3);
  rows[1].stiffness = 50;
  rows[1].add(5, 2), rows[1].add(60, -3), rows[1].add(9, 1);

  VertexSystem system;
  system.shape(surface, weights, rows);
  system.assemble(goals, tau);
  system.beginPrepare();
  for (double share = 0; share < 1;) REQUIRE(system.prepareNext(share).ok());
  Points positions = surface.mesh.positions;
  for (int round = 0; round < 3; ++round) REQUIRE(system.solve(1e-5, positions).ok());

  // The normal term of the solve has target lengths where the energy has present ones.
  const auto energyAt = [&](const Points& at) {
    EnergyWeights withoutNormals = weights;
    withoutNormals.normal = 0;
    double energy = vertexEnergy(surface, withoutNormals, goals, tau, at) + rowEnergy(rows, at);
    for (Index h = 0; h < surface.halfEdgeCount(); ++h) {
      const Triangles& triangles = surface.mesh.triangles;
      const Eigen::RowVector3d e =
          at.row(triangles(faceOf(h), headCorner(h))) - at.row(triangles(faceOf(h), tailCorner(h)));
      const double across = goals.normals.row(h).dot(e) / goals.targetLengths[h];
      energy += weights.normal * goals.stress[h] * goals.lengths[h] / surface.averageLength * across * across;
    }
    return energy;
  };
  const double at = energyAt(positions);
  for (int trial = 0; trial < 5; ++trial) {
    Points direction(surface.vertexCount(), 3);
    for (Index v = 0; v < direction.rows(); ++v) direction.row(v) = noise.direction().transpose();
    const double up = energyAt(positions + 1e-3 * direction), down = energyAt(positions - 1e-3 * direction);
    CHECK(up > at);
    CHECK(down > at);
    CHECK(std::abs(up - down) < 1e-3 * (up + down - 2 * at));
  }
}

TEST_CASE("the energy of a uniform scale is that of the scale terms alone where all is sphere") {
  TriangleMesh mesh = sphere(3);
  mesh.positions *= 0.5;
  RestSurface surface = measureSurface(mesh);
  setTerms(ReshapeTerms::of(Variant::alup, Reading::tuned, Rung::full), {}, {}, surface);
  const EnergyWeights weights = ReshapeTerms::of(Variant::alup, Reading::tuned, Rung::full).weights;
  const double scale = 1.7;
  EdgeGoals goals = restGoals(surface);
  const Transformations tau(surface.faceCount(), scale * Mat3::Identity());
  CHECK(vertexEnergy(surface, weights, goals, tau, scale * mesh.positions) < 1e-12);
  TransformationSystem system;
  system.shape(surface, weights);
  CHECK(system.energy(tau) ==
        doctest::Approx(3 * weights.regularizer * surface.faceCount() * (scale - 1) * (scale - 1)));
}

TEST_CASE("the mean of two face normals is orthogonal to their edge, and creases keep their own") {
  TriangleMesh mesh = cylinder(12, 6, 2, 1, 2, true);
  RestSurface surface = measureSurface(mesh);
  setEdgeNormals(surface, 65 * EIGEN_PI / 180);
  Index means = 0;
  for (const FacePair& pair : surface.pairs) {
    const Eigen::RowVector3d n = surface.edgeNormals.row(pair.first);
    CHECK(std::abs(n.dot(surface.halfEdges.row(pair.first))) < 1e-9);
    CHECK(n.norm() == doctest::Approx(1));
    const bool isMean = (n - surface.edgeNormals.row(pair.second)).norm() < 1e-12;
    CHECK(isMean == (pair.angle < 65 * EIGEN_PI / 180));
    means += isMean && pair.angle > 0.1;
  }
  CHECK(means > 50);
}
