// The energy of a shell with plastic degrees of freedom and its derivatives, against differences.
#include "methods/plastic/shell.h"

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "methods/plastic/sensitivity.h"
#include "methods/plastic/stiffness.h"
#include "support/shapes.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

constexpr double kStep = 1e-5;

/// A shell with something plastic on every face, in a shape of its own.
struct Case {
  Shell shell;
  PlasticField field;
  Points positions;

  explicit Case(const TriangleMesh& mesh, double plastic = 0.2, double moved = 0.02) : positions(mesh.positions) {
    shell.setRest(mesh, {0.1, 0.3});
    Noise noise;
    field = PlasticField::identity(mesh.faceCount());
    Scalars change(6 * mesh.faceCount());
    for (double& number : change) number = noise();
    field.add(change, plastic);
    for (Index i = 0; i < positions.size(); ++i) positions.data()[i] += moved * noise();
    shell.setPlastic(field);
    shell.setShape(positions);
  }

  Points gradientAt(const Points& where) {
    Points gradient(shell.vertexCount(), 3);
    shell.setShape(where);
    shell.energy(gradient);
    return gradient;
  }
};

std::vector<TriangleMesh> someMeshes() { return {bent(sphere(1)), bent(grid(4)), bent(moebiusStrip(8))}; }

Scalars someField(Index faces) {
  Noise noise;
  Scalars field(6 * faces);
  for (double& number : field) number = noise();
  return field;
}

std::vector<Index> allFree(Index count) {
  std::vector<Index> nodes(count);
  for (Index v = 0; v < count; ++v) nodes[v] = v;
  return nodes;
}

}  // namespace

TEST_CASE("a shell at rest has no energy, no force, and no pressed face") {
  for (const TriangleMesh& mesh : someMeshes()) {
    Shell shell;
    shell.setRest(mesh, {0.1, 0.3});
    Points gradient(mesh.vertexCount(), 3);
    CHECK(shell.energy(gradient) < 1e-26);
    CHECK(gradient.norm() < 1e-12);
    CHECK(std::abs(shell.smallestSquaredStretch() - 1) < 1e-12);
  }
}

TEST_CASE("rigid motions leave the energy as it is, and so does one rotation for all faces") {
  for (const TriangleMesh& mesh : someMeshes()) {
    Case one(mesh);
    const double energy = one.shell.energy();
    one.shell.setShape((one.positions * someRotation().transpose()).rowwise() + Vec3(3, -2, 5).transpose());
    CHECK(std::abs(one.shell.energy() - energy) < 1e-12 * energy);
    const Eigen::AngleAxisd common(0.7, Vec3(1, 2, 3).normalized());
    for (Vec3& theta : one.field.rotations) {
      const Eigen::AngleAxisd turned(Mat3(common.toRotationMatrix() * rotationOf(theta)));
      theta = turned.angle() * turned.axis();
    }
    one.shell.setPlastic(one.field);
    CHECK(std::abs(one.shell.energy() - energy) < 1e-11 * energy);
  }
}

TEST_CASE("a shell that is to be turned and grown the same all over is at rest in the larger shape") {
  for (const TriangleMesh& mesh : someMeshes()) {
    Shell shell;
    shell.setRest(mesh, {0.1, 0.3});
    PlasticField field = PlasticField::identity(mesh.faceCount());
    for (Mat2& stretch : field.stretches) stretch *= 1.5;
    shell.setPlastic(field);
    shell.setShape(1.5 * mesh.positions);
    CHECK(shell.energy() < 1e-24);
  }
}

TEST_CASE("the gradient is that of differences of the energy") {
  for (const TriangleMesh& mesh : someMeshes()) {
    Case one(mesh);
    const Points gradient = one.gradientAt(one.positions);
    double worst = 0;
    for (Index i = 0; i < gradient.size(); ++i) {
      double energies[2];
      for (int side = 0; side < 2; ++side) {
        Points moved = one.positions;
        moved.data()[i] += side == 0 ? kStep : -kStep;
        one.shell.setShape(moved);
        energies[side] = one.shell.energy();
      }
      worst = std::max(worst, std::abs((energies[0] - energies[1]) / (2 * kStep) - gradient.data()[i]));
    }
    CHECK(worst < 1e-7 * gradient.cwiseAbs().maxCoeff());
  }
}

TEST_CASE("at rest the stiffness is the derivative of the gradient") {
  for (const TriangleMesh& mesh : someMeshes()) {
    Case one(mesh, 0, 0);
    Stiffness stiffness(one.shell, allFree(mesh.vertexCount()));
    stiffness.assemble(one.shell);
    const Eigen::MatrixXd K = Eigen::MatrixXd(stiffness.matrix()).selfadjointView<Eigen::Lower>();
    double worst = 0;
    for (Index i = 0; i < one.positions.size(); ++i) {
      Points ahead = one.positions, back = one.positions;
      ahead.data()[i] += kStep;
      back.data()[i] -= kStep;
      const Points slope = (one.gradientAt(ahead) - one.gradientAt(back)) / (2 * kStep);
      worst = std::max(worst, (Eigen::Map<const Scalars>(slope.data(), slope.size()) - K.col(i)).norm());
    }
    CHECK(worst < 1e-7 * K.cwiseAbs().maxCoeff());
  }
}

TEST_CASE("the stiffness has no negative direction in any shape") {
  for (const TriangleMesh& mesh : someMeshes()) {
    Case one(mesh, 0.2, 0.2);
    Stiffness stiffness(one.shell, allFree(mesh.vertexCount()));
    stiffness.assemble(one.shell);
    const Eigen::MatrixXd K = Eigen::MatrixXd(stiffness.matrix()).selfadjointView<Eigen::Lower>();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(K);
    CHECK(eigen.eigenvalues().minCoeff() > -1e-12 * eigen.eigenvalues().maxCoeff());
  }
}

TEST_CASE("vertices that are held are left out of the stiffness") {
  const TriangleMesh mesh = bent(grid(4));
  Case one(mesh);
  std::vector<Index> nodeOf = allFree(mesh.vertexCount());
  Stiffness whole(one.shell, nodeOf);
  whole.assemble(one.shell);
  const Eigen::MatrixXd all = Eigen::MatrixXd(whole.matrix()).selfadjointView<Eigen::Lower>();
  nodeOf[5] = -1;
  for (Index v = 6; v < mesh.vertexCount(); ++v) --nodeOf[v];
  Stiffness part(one.shell, nodeOf);
  part.assemble(one.shell);
  const Eigen::MatrixXd free = Eigen::MatrixXd(part.matrix()).selfadjointView<Eigen::Lower>();
  CHECK((free.topLeftCorner(15, 15) - all.topLeftCorner(15, 15)).norm() == 0);
  CHECK((free.bottomRightCorner(30, 30) - all.bottomRightCorner(30, 30)).norm() == 0);
}

TEST_CASE("sensitivities are those of differences of the gradient") {
  for (const TriangleMesh& mesh : someMeshes()) {
    Case one(mesh);
    Sensitivity sensitivity;
    sensitivity.take(one.shell);
    const Scalars change = someField(mesh.faceCount());
    Sensitivity::Rows forces;
    sensitivity.apply(change, forces);
    Points slope[2];
    for (int side = 0; side < 2; ++side) {
      PlasticField moved = one.field;
      moved.add(change, side == 0 ? kStep : -kStep);
      one.shell.setPlastic(moved);
      slope[side] = one.gradientAt(one.positions);
    }
    const Points difference = (slope[0] - slope[1]) / (2 * kStep);
    CHECK((Eigen::Map<const Scalars>(difference.data(), difference.size()) - forces.col(0)).norm() <
          1e-7 * difference.norm());
  }
}

TEST_CASE("sensitivities the other way round are their transpose") {
  for (const TriangleMesh& mesh : someMeshes()) {
    Case one(mesh);
    Sensitivity sensitivity;
    sensitivity.take(one.shell);
    Noise noise;
    Sensitivity::Rows Y(3 * mesh.vertexCount(), 2), back;
    for (Index i = 0; i < Y.size(); ++i) Y.data()[i] = noise();
    sensitivity.applyTransposed(Y, back);
    const Scalars change = someField(mesh.faceCount());
    Sensitivity::Rows forces;
    sensitivity.apply(change, forces);
    for (Index column = 0; column < 2; ++column) {
      const double there = forces.col(0).dot(Y.col(column));
      CHECK(std::abs(there - change.dot(back.col(column))) < 1e-12 * std::abs(there));
    }
  }
}
