#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <cmath>

#include "optimization/constrained_descent.h"
#include "optimization/dual_gauss_newton.h"
#include "optimization/limited_memory.h"
#include "support/shapes.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

Eigen::MatrixXd someMatrix(Noise& noise, Index rows, Index columns) {
  Eigen::MatrixXd matrix(rows, columns);
  for (Index i = 0; i < matrix.size(); ++i) matrix.data()[i] = noise();
  return matrix;
}

Eigen::MatrixXd someDefinite(Noise& noise, Index size) {
  const Eigen::MatrixXd root = someMatrix(noise, size, size);
  return root * root.transpose() + 0.1 * Eigen::MatrixXd::Identity(size, size);
}

}  // namespace

TEST_CASE("on a quadratic, exact steps with memory end where the gradient is zero, in as many steps as unknowns") {
  Noise noise;
  constexpr Index kSize = 8;
  const Eigen::MatrixXd A = someDefinite(noise, kSize);
  const Scalars b = someMatrix(noise, kSize, 1);
  LimitedMemory memory(10);
  Scalars x = Scalars::Zero(kSize), gradient = A * x - b, direction;
  const auto inverse = [](Scalars& v) { v *= 0.3; };
  for (Index step = 0; step < kSize; ++step) {
    memory.direction(gradient, inverse, direction);
    CHECK(direction.dot(gradient) < 0);
    const double length = -gradient.dot(direction) / direction.dot(A * direction);
    const Scalars move = length * direction;
    const Scalars next = gradient + A * move;
    memory.remember(move, next - gradient);
    x += move;
    gradient = next;
  }
  CHECK(gradient.norm() < 1e-8 * b.norm());
}

TEST_CASE("what curves downwards is not remembered, and what is forgotten counts no more") {
  LimitedMemory memory(3);
  const Scalars gradient = Vec3(1, 2, 3);
  const auto inverse = [](Scalars& v) { v *= 2; };
  Scalars plain, direction;
  memory.direction(gradient, inverse, plain);
  CHECK((plain + 2 * gradient).norm() == 0);
  memory.remember(Vec3(1, 0, 0), Vec3(-1, 0, 0));
  memory.direction(gradient, inverse, direction);
  CHECK((direction - plain).norm() == 0);
  memory.remember(Vec3(1, 0, 0), Vec3(3, 0, 0));
  memory.direction(gradient, inverse, direction);
  CHECK(direction[0] == doctest::Approx(-1.0 / 3));
  memory.forget();
  memory.direction(gradient, inverse, direction);
  CHECK((direction - plain).norm() == 0);
}

TEST_CASE("the step from the residuals is the minimum over all unknowns") {
  Noise noise;
  constexpr Index kResiduals = 6, kUnknowns = 15;
  const Eigen::MatrixXd A = someDefinite(noise, kUnknowns), J = someMatrix(noise, kResiduals, kUnknowns);
  const Scalars r = someMatrix(noise, kResiduals, 1), q0 = someMatrix(noise, kUnknowns, 1);
  for (const Index free : {0, 2}) {
    const Eigen::MatrixXd G = someMatrix(noise, kResiduals, free);
    const Eigen::MatrixXd W = A.inverse() * J.transpose();
    DualStep step;
    REQUIRE(solveDual(J * W, J * q0 - r, G, step).ok());
    const Scalars q = W * step.multipliers;
    const Scalars left = r + J * (q - q0) + G * step.free;
    CHECK((J.transpose() * left + A * q).norm() < 1e-9);
    CHECK((G.transpose() * left).norm() < 1e-9);
    CHECK((left + step.multipliers).norm() < 1e-9);
  }
}

TEST_CASE("free unknowns that nothing depends on, or that do the same, leave a step that is finite") {
  Noise noise;
  Eigen::MatrixXd G(3, 3);
  G << 1, 1, 0, 2, 2, 0, 0, 0, 0;
  DualStep step;
  REQUIRE(solveDual(Eigen::MatrixXd::Identity(3, 3), Vec3(1, 2, 3), G, step).ok());
  CHECK(step.free[0] == doctest::Approx(0.5));
  CHECK(step.free[1] == doctest::Approx(0.5));
  CHECK(step.free[2] == doctest::Approx(0));
}

TEST_CASE("numbers that are not finite are refused") {
  DualStep step;
  const Scalars bad = Vec3(1, std::nan(""), 0);
  CHECK(solveDual(Eigen::MatrixXd::Identity(3, 3), bad, Eigen::MatrixXd(3, 0), step).code == Code::numericalFailure);
}

TEST_CASE("a low-rank inverse of what has that rank, and a rest, is the inverse") {
  Noise noise;
  const Eigen::MatrixXd root = someMatrix(noise, 12, 4), K = root * root.transpose();
  const std::vector<Index> known = {1, 4, 7, 10};
  Eigen::MatrixXd C(12, 4);
  for (Index c = 0; c < 4; ++c) C.col(c) = K.col(known[c]);
  LowRankInverse inverse;
  inverse.take(C, known, 1.5);
  const Eigen::MatrixXd M = K + 1.5 * Eigen::MatrixXd::Identity(12, 12);
  CHECK((inverse.apply(M) - Eigen::MatrixXd::Identity(12, 12)).norm() < 1e-8);
}

TEST_CASE("descent by products alone comes to the dual step, in few of them where most columns are known") {
  Noise noise;
  const Eigen::MatrixXd root = someMatrix(noise, 40, 8);
  const Eigen::MatrixXd K = 100 * root * root.transpose() + 0.2 * someDefinite(noise, 40);
  const Scalars y = someMatrix(noise, 40, 1);
  const std::vector<Index> known = {0, 5, 10, 15, 20, 25, 30, 35};
  Eigen::MatrixXd C(40, 8);
  for (Index c = 0; c < 8; ++c) C.col(c) = K.col(known[c]);
  for (const Index free : {0, 3}) {
    const Eigen::MatrixXd G = someMatrix(noise, 40, free);
    DualStep step;
    REQUIRE(solveDual(K, y, G, step).ok());
    LowRankInverse inverse;
    inverse.take(C, known, 3);
    ConstrainedDescent descent;
    descent.begin(y, G, inverse, {.residual = 1e-9, .iterations = 100});
    while (!descent.isDone()) descent.advance(descent.direction() + K * descent.direction());
    CHECK((descent.multipliers() - step.multipliers).norm() < 1e-7 * step.multipliers.norm());
    CHECK((descent.free() - step.free).norm() <= 1e-7 * step.free.norm());
    CHECK(descent.iterations() < 40);
  }
}
