#include "geometry/rotation_fit.h"

#include <doctest/doctest.h>

#include "support/shapes.h"

using namespace whittle;
using testing::Noise;

namespace {

double gain(const Mat3& R, const Mat3& M) { return (R * M).trace(); }

void requireRotation(const Mat3& R) {
  REQUIRE((R.transpose() * R - Mat3::Identity()).norm() < 1e-12);
  REQUIRE(R.determinant() > 0);
}

/// Matrices of every awkward kind, with the given singular values (signed, so reflections are among them).
Mat3 withSingularValues(Noise& noise, const Vec3& values) {
  return noise.rotation() * values.asDiagonal() * noise.rotation();
}

}  // namespace

TEST_CASE("the fit from the decomposition beats every other rotation") {
  Noise noise;
  for (const Vec3& values : {Vec3(3, 2, 1), Vec3(3, 2, -1), Vec3(1, 1, 0), Vec3(1, 0, 0), Vec3(0, 0, 0), Vec3(1, 1, -1),
                             Vec3(1, 0.3, -0.2999), Vec3(1, 1e-4, 1e-8), Vec3(1e-12, 1e-12, -1e-12)}) {
    const Mat3 M = withSingularValues(noise, values);
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
      const Mat3 M = withSingularValues(noise, values);
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
