#include "geometry/rotation_fit.h"

#include <doctest/doctest.h>

#include <iterator>

#include "geometry/rotation_newton.h"
#include "support/shapes.h"

using namespace whittle;
using testing::Noise;

namespace {

double gain(const Mat3& R, const Mat3& M) { return (R * M).trace(); }

void requireRotation(const Mat3& R) {
  REQUIRE((R.transpose() * R - Mat3::Identity()).norm() < 1e-12);
  REQUIRE(R.determinant() > 0);
}

}  // namespace

TEST_CASE("the fit from the decomposition beats every other rotation") {
  Noise noise;
  for (const Vec3& values : {Vec3(3, 2, 1), Vec3(3, 2, -1), Vec3(1, 1, 0), Vec3(1, 0, 0), Vec3(0, 0, 0), Vec3(1, 1, -1),
                             Vec3(1, 0.3, -0.2999), Vec3(1, 1e-4, 1e-8), Vec3(1e-12, 1e-12, -1e-12)}) {
    const Mat3 M = noise.withSingularValues(values);
    const Mat3 R = fitRotation(M);
    requireRotation(R);
    CHECK(gain(R, M) == doctest::Approx(values.sum()).epsilon(1e-12));
    for (int trial = 0; trial < 200; ++trial) CHECK(gain(noise.rotation(), M) <= gain(R, M) + 1e-12);
  }
}

TEST_CASE("the warm fit finds the same maximum from anywhere") {
  Noise noise;
  for (int trial = 0; trial < 3000; ++trial) {
    const Mat3 M = noise.matrix();  // half of them with negative determinant
    const Mat3 R = fitRotation(M, noise.rotation());
    requireRotation(R);
    REQUIRE(gain(R, M) == doctest::Approx(gain(fitRotation(M), M)).epsilon(1e-12));
  }
}

TEST_CASE("the warm fit survives matrices without a unique answer") {
  Noise noise;
  for (const Vec3& values : {Vec3(1, 1, -1), Vec3(1, 0, 0), Vec3(0, 0, 0), Vec3(1, 1e-9, -1e-9)}) {
    for (int trial = 0; trial < 100; ++trial) {
      const Mat3 M = noise.withSingularValues(values);
      const Mat3 R = fitRotation(M, noise.rotation());
      requireRotation(R);
      CHECK(gain(R, M) == doctest::Approx(values.sum()).epsilon(1e-9));
    }
  }
}

TEST_CASE("a thousand warm fits in a row leave a rotation") {
  Noise noise;
  Mat3 R = Mat3::Identity();
  for (int step = 0; step < 1000; ++step) {
    const Mat3 target = Eigen::AngleAxisd(0.01 * step, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    R = fitRotation((target + 0.05 * noise.matrix()).transpose(), R);
  }
  CHECK((R.transpose() * R - Mat3::Identity()).norm() < 1e-14);
}

TEST_CASE("four fits at once find the maximum of every awkward matrix") {
  Noise noise;
  const Vec3 awkward[] = {{3, 2, 1},         {3, 2, -1},      {1, 1, 0},
                          {1, 0, 0},         {0, 0, 0},       {1, 1, -1},
                          {1, 0.3, -0.2999}, {1, 1e-4, 1e-8}, {1e-12, 1e-12, -1e-12},
                          {1e9, 1e9, 1e3}};
  for (int trial = 0; trial < 400; ++trial) {
    MatrixLanes M;
    QuaternionLanes rotations = identityRotations();
    for (int lane = 0; lane < 4; ++lane) {
      setMatrix(M, lane, noise.withSingularValues(awkward[(trial + 3 * lane) % std::size(awkward)]));
      setRotation(rotations, lane, noise.rotation());
    }
    fitRotations(M, rotations);
    const Lanes found = trace(toMatrix(rotations) * M);
    for (int lane = 0; lane < 4; ++lane) {
      const Mat3 matrix = matrixAt(M, lane);
      const Mat3 R = rotationAt(rotations, lane);
      requireRotation(R);
      REQUIRE(std::abs(found[lane] - gain(R, matrix)) <= 1e-6 * matrix.norm());
      REQUIRE(gain(R, matrix) >= gain(fitRotation(matrix), matrix) - 2e-6 * matrix.norm());
    }
  }
}

TEST_CASE("warm fits in single precision are good to its rounding") {
  Noise noise;
  for (int trial = 0; trial < 500; ++trial) {
    MatrixLanes M;
    QuaternionLanes rotations;
    Mat3 exact[4];
    for (int lane = 0; lane < 4; ++lane) {
      const Mat3 turn = noise.rotation();
      const Mat3 matrix = (Mat3(Vec3(1, 0.8, 0.1).asDiagonal()) + 0.05 * noise.matrix()) * turn;
      exact[lane] = fitRotation(matrix);
      setMatrix(M, lane, matrix);
      setRotation(rotations, lane, cayley(0.07 * noise.direction()) * exact[lane]);
    }
    fitRotations(M, rotations);
    for (int lane = 0; lane < 4; ++lane) REQUIRE((rotationAt(rotations, lane) - exact[lane]).norm() < 2e-6);
  }
}
