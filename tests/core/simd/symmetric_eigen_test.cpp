#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "simd/symmetric_eigen.h"
#include "support/shapes.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

SymmetricLanes lanesOf(const Mat3 (&A)[4]) {
  const auto entry = [&](int i, int j) {
    return Lanes{float(A[0](i, j)), float(A[1](i, j)), float(A[2](i, j)), float(A[3](i, j))};
  };
  return {entry(0, 0), entry(0, 1), entry(0, 2), entry(1, 1), entry(1, 2), entry(2, 2)};
}

/// Holds four decompositions against a plain solver and against what they promise.
void check(const Mat3 (&A)[4]) {
  const EigenLanes eigen = eigenDecomposition(lanesOf(A));
  for (int lane = 0; lane < 4; ++lane) {
    const Vec3 plain = Eigen::SelfAdjointEigenSolver<Mat3>(A[lane]).eigenvalues().reverse();
    const double size = std::max(A[lane].norm(), 1e-30);
    Mat3 vectors, rebuilt = Mat3::Zero();
    for (int i = 0; i < 3; ++i) {
      CHECK(std::abs(eigen.values[i][lane] - plain[i]) < 2e-6 * size);
      vectors.col(i) = vectorAt(eigen.vectors[i], lane);
      rebuilt += eigen.values[i][lane] * vectors.col(i) * vectors.col(i).transpose();
    }
    CHECK((vectors.transpose() * vectors - Mat3::Identity()).norm() < 2e-6);
    CHECK((rebuilt - A[lane]).norm() < 3e-6 * size);
  }
}

}  // namespace

TEST_CASE("eigenvalues and eigenvectors are those of a plain solver") {
  Noise noise;
  for (int trial = 0; trial < 100; ++trial) {
    Mat3 A[4];
    for (Mat3& matrix : A) {
      const Mat3 B = noise.matrix();
      matrix = B * B.transpose();
    }
    check(A);
  }
}

TEST_CASE("values that coincide or vanish are no trouble") {
  Noise noise;
  const auto with = [&](const Vec3& values) -> Mat3 {
    const Mat3 Q = noise.rotation();
    return Q * values.asDiagonal() * Q.transpose();
  };
  for (int trial = 0; trial < 30; ++trial) {
    const Mat3 some[4] = {with({1, 1, 1}), with({1, 1, 0}), with({1, 0, 0}), with({2, 1e-4, 1e-4})};
    check(some);
    const Mat3 others[4] = {Mat3::Zero(), Mat3(Vec3(1, 3, 2).asDiagonal()), 1e-8 * with({3, 2, 1}),
                            with({1, 1e-3, 1e-5})};
    check(others);
  }
}
