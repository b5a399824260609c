// What plastic change costs: nothing for what is the same all over, in whatever frames and numbering faces come.
#include "methods/plastic/plastic_prior.h"

#include <doctest/doctest.h>

#include <cmath>

#include "support/shapes.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

Shell shellOf(const TriangleMesh& mesh) {
  Shell shell;
  shell.setRest(mesh, {0.1, 0.3});
  return shell;
}

/// A sheet in the plane whose faces start at any of their corners and look either way.
TriangleMesh mixedSheet() {
  TriangleMesh mesh = grid(6);
  for (Index v = 0; v < mesh.vertexCount(); ++v) mesh.positions(v, 0) += 0.3 * mesh.positions(v, 1);
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    for (Index turn = 0; turn < f % 3; ++turn) {
      mesh.triangles.row(f) = Eigen::RowVector3i(mesh.triangles(f, 1), mesh.triangles(f, 2), mesh.triangles(f, 0));
    }
    if (f % 4 == 1) std::swap(mesh.triangles(f, 0), mesh.triangles(f, 1));
  }
  return mesh;
}

/// Gives all faces the same turn and stretch in space.
Scalars sameAllOver(const Shell& shell, const Vec3& turn, const Mat3& stretch) {
  const Index faces = shell.faceCount();
  Scalars field(6 * faces);
  for (Index f = 0; f < faces; ++f) {
    const Mat32& axes = shell.frames()[f].axes;
    const Mat2 S = axes.transpose() * stretch * axes;
    field.segment<3>(3 * f) = turn;
    field[3 * faces + f] = S.trace() / std::sqrt(2.0);
    field[4 * faces + 2 * f] = (S(0, 0) - S(1, 1)) / std::sqrt(2.0);
    field[4 * faces + 2 * f + 1] = 2 * S(0, 1) / std::sqrt(2.0);
  }
  return field;
}

void prepare(PlasticPrior& prior) {
  for (double share = 0; share < 1;) REQUIRE(prior.prepareNext(share).ok());
}

void solve(PlasticPrior& prior, PlasticPrior::Rows& columns) {
  prior.beginSolve(columns);
  for (bool isDone = false; !isDone;) REQUIRE(prior.solveNext(isDone).ok());
}

}  // namespace

TEST_CASE("stretches have the Frobenius norm") {
  Noise noise;
  const Vec3 numbers = noise.direction();
  CHECK(stretchOf(numbers).norm() == doctest::Approx(1));
}

TEST_CASE("on a plane the same turn and stretch everywhere is smooth, however faces are numbered and look") {
  const Shell shell = shellOf(mixedSheet());
  Mat3 stretch;
  stretch << 1, 0.4, 0, 0.4, -0.3, 0, 0, 0, 0;
  PlasticPrior prior;
  prior.shape(shell, 10, 1e-12);
  const Scalars same = sameAllOver(shell, Vec3(1, 2, 3), stretch);
  CHECK(prior.energy(same) < 1e-9);
  Scalars other = same;
  other[0] += 1;
  CHECK(prior.energy(other) > 1);
  other = same;
  other[4 * shell.faceCount()] += 1;
  CHECK(prior.energy(other) > 1);
}

TEST_CASE("what changes over a length costs the same, however finely the surface is cut") {
  double costs[2];
  for (const int finer : {0, 1}) {
    TriangleMesh mesh = grid(finer == 0 ? 17 : 33);
    mesh.positions.col(0) -= mesh.positions.col(1) / 2;  // faces become equilateral
    mesh.positions.col(1) *= std::sqrt(0.75);
    const Shell shell = shellOf(mesh);
    const Index faces = shell.faceCount();
    Scalars field = Scalars::Zero(6 * faces);
    // A hill that is flat at the border.
    const Vec3 middle = mesh.positions.colwise().mean();
    for (Index f = 0; f < faces; ++f) {
      const Vec3 center = (shell.input().corner(f, 0) + shell.input().corner(f, 1) + shell.input().corner(f, 2)) / 3;
      field[3 * faces + f] = std::exp(-(center - middle).squaredNorm() / 0.02);
    }
    // The price is by the fourth power of lengths in sides, and by faces.
    const double side = meanSide(shell);
    PlasticPrior prior;
    prior.shape(shell, 1, 0);
    costs[finer] = prior.energy(field) / (std::pow(side, 4) * faces);
  }
  CHECK(costs[1] / costs[0] > 0.85);
  CHECK(costs[1] / costs[0] < 1.15);
}

TEST_CASE("columns are solved to double precision") {
  const Shell shell = shellOf(bent(sphere(2)));
  PlasticPrior prior;
  prior.shape(shell, 10, 0.01);
  prepare(prior);
  Noise noise;
  PlasticPrior::Rows loads(6 * shell.faceCount(), 7);
  for (Index i = 0; i < loads.size(); ++i) loads.data()[i] = noise();
  PlasticPrior::Rows fields = loads;
  solve(prior, fields);
  for (Index column = 0; column < loads.cols(); ++column) {
    const double work = fields.col(column).dot(loads.col(column));
    CHECK(prior.energy(fields.col(column)) == doctest::Approx(work).epsilon(1e-8));
  }
}

TEST_CASE("without β growth of all of a part is free, and the rest is solved as if nothing were held") {
  const TriangleMesh ball = bent(sphere(2));
  const Shell shell = shellOf(together(ball, ball, Vec3(5, 0, 0)));
  PlasticPrior prior;
  prior.shape(shell, 10, 0);
  prepare(prior);
  REQUIRE(prior.growth().cols() == 2);
  CHECK(std::abs(prior.energy(prior.growth().col(0))) < 1e-12);

  // Loads in balance over each part, and moved growth that they do no work on.
  const Index faces = shell.faceCount();
  Noise noise;
  Scalars load = Scalars::Zero(6 * faces);
  for (Index f = 0; f < faces; ++f) load[3 * faces + f] = noise();
  for (Index part = 0; part < 2; ++part) {
    const Scalars members = prior.growth().col(part);
    load -= load.dot(members) / members.squaredNorm() * members;
  }
  PlasticPrior::Rows fields = load;
  solve(prior, fields);
  const Scalars field = fields.col(0);
  CHECK(prior.energy(field) == doctest::Approx(field.dot(load)).epsilon(1e-7));
  Scalars aside = Scalars::Zero(6 * faces);
  for (Index f = 0; f < faces; ++f) aside[3 * faces + f] = noise();
  const double slope = (prior.energy(field + aside) - prior.energy(field - aside)) / 4;
  CHECK(slope == doctest::Approx(load.dot(aside)).epsilon(1e-6));
}
