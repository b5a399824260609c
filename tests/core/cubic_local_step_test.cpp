#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "geometry/rotation_fit.h"
#include "methods/local_global/cubic_admm.h"
#include "methods/local_global/cubic_exact.h"
#include "methods/local_global/cubic_search.h"
#include "support/allocations.h"
#include "support/shapes.h"

using namespace whittle;
using testing::Noise;

namespace {

struct Vertex {
  Mat3 M;
  Vec3 n;
  double weight;
  Mat3 guess;

  double objective(const Mat3& R) const { return cubicObjective(M, n, weight, R); }
  /// What objectives are measured against.
  double scale() const { return M.norm() + weight; }
};

Vertex vertexOf(Noise& noise, const Mat3& M, double weight) {
  return {M, Vec3(noise(), noise(), noise()).normalized(), weight, noise.rotation()};
}

/// Covariances of every awkward kind: random, reflected, of rank 2, 1 and 0, with equal singular values, tiny.
std::vector<Mat3> awkwardCovariances(Noise& noise) {
  std::vector<Mat3> matrices = {noise.matrix(), Mat3::Zero(), Mat3::Identity()};
  for (const Vec3& values : {Vec3(3, 2, 1), Vec3(3, 2, -1), Vec3(1, 1, 0), Vec3(1, 0, 0), Vec3(1, 1, -1), Vec3(1, 0.3, -0.2999),
                             Vec3(1, 1e-4, 1e-8), Vec3(1e-12, 1e-12, 0)}) {
    matrices.push_back(noise.rotation() * values.asDiagonal() * noise.rotation());
  }
  return matrices;
}

/// A vertex of a surface at work: the tangent projector of a smooth neighbourhood, somewhat turned, bent and noisy.
Vertex surfaceVertex(Noise& noise, double lambda, double area) {
  Vertex vertex = vertexOf(noise, Mat3::Zero(), lambda * area);
  const Mat3 projector = Mat3::Identity() - vertex.n * vertex.n.transpose();
  const Mat3 turn = Eigen::AngleAxisd(0.5 * noise(), Vec3(noise(), noise(), noise()).normalized()).toRotationMatrix();
  vertex.M = area * (6 * projector * turn.transpose() + 0.3 * noise.matrix());
  vertex.guess = fitRotation(vertex.M);
  return vertex;
}

double solveExactly(const Vertex& vertex, bool* certified = nullptr) {
  Mat3 R = vertex.guess;
  Vec3 u = Vec3::Zero();
  const bool proved = CubicExact::solveCertified(vertex.M, vertex.n, vertex.weight, u, R);
  if (certified) *certified = proved;
  REQUIRE((R.transpose() * R - Mat3::Identity()).norm() < 1e-12);
  REQUIRE(R.determinant() > 0);
  // u is a subgradient either way, which is what makes the certificate one.
  REQUIRE(u.cwiseAbs().maxCoeff() <= 1 + 1e-8);
  REQUIRE((R * vertex.n).lpNorm<1>() - u.dot(R * vertex.n) < 1e-7);
  return vertex.objective(R);
}

/// The best of random rotations and of small turns of the best so far.
double bruteForce(Noise& noise, const Vertex& vertex) {
  Mat3 best = vertex.guess;
  const auto offer = [&](const Mat3& R) {
    if (vertex.objective(R) > vertex.objective(best)) best = R;
  };
  for (int trial = 0; trial < 150; ++trial) offer(noise.rotation());
  for (double angle = 1; angle > 1e-4; angle *= 0.93) {
    offer(Eigen::AngleAxisd(angle, Vec3(noise(), noise(), noise()).normalized()).toRotationMatrix() * best);
  }
  return vertex.objective(best);
}

double minimisedDual(const Vertex& vertex, const Vec3& u) {
  const Mat3 M = vertex.M - vertex.weight * vertex.n * u.transpose();
  return fitRotation(M).cwiseProduct(M.transpose()).sum();
}

}  // namespace

TEST_CASE("brute force never beats the exact step") {
  Noise noise;
  for (const double lambda : {0.01, 0.2, 1.0, 3.0, 4.5, 5.9}) {
    for (int trial = 0; trial < 8; ++trial) {
      for (const Mat3& M : awkwardCovariances(noise)) {
        const double weight = lambda * std::max(M.norm(), 1e-12) / 6;
        for (Vertex vertex : {vertexOf(noise, M, weight), vertexOf(noise, M, 1e-30), surfaceVertex(noise, lambda, 1e-9)}) {
          if (trial < 3) vertex.n = Vec3::Unit(trial);
          REQUIRE(bruteForce(noise, vertex) <= solveExactly(vertex) + 1e-10 * vertex.scale());
        }
      }
    }
  }
}

TEST_CASE("a certified step has no duality gap, and small lambdas are certified") {
  Noise noise;
  for (const double lambda : {0.05, 0.4, 1.5}) {
    int certifiedCount = 0;
    for (int trial = 0; trial < 500; ++trial) {
      const Vertex vertex = surfaceVertex(noise, lambda, 1e-4);
      Mat3 R = vertex.guess;
      Vec3 u = Vec3::Zero();
      if (!CubicExact::solveCertified(vertex.M, vertex.n, vertex.weight, u, R)) continue;
      ++certifiedCount;
      const double gap = minimisedDual(vertex, u.cwiseMax(-1).cwiseMin(1)) - vertex.objective(R);
      REQUIRE(std::abs(gap) < 1e-9 * vertex.scale());
    }
    CHECK(certifiedCount >= 495);
  }
}

TEST_CASE("the search alone finds what Newton's method certifies") {
  Noise noise;
  for (int trial = 0; trial < 300; ++trial) {
    const Vertex vertex = surfaceVertex(noise, 0.1 * (1 + trial % 30), 1);
    const double exact = solveExactly(vertex);
    const double searched = vertex.objective(searchCubic(vertex.M, vertex.n, vertex.weight, noise.rotation()));
    REQUIRE(searched == doctest::Approx(exact).epsilon(1e-9));
  }
}

TEST_CASE("the exact step agrees with a tight ADMM") {
  Noise noise;
  CubicAdmm admm({1e-12, 1e-10, 1e-10, 20000});
  for (const double lambda : {0.05, 0.2, 0.4, 1.0, 2.0}) {
    for (int trial = 0; trial < 30; ++trial) {
      const Vertex vertex = surfaceVertex(noise, lambda, 1e-3);
      admm.begin(Scalars::Constant(1, vertex.weight));
      Mat3 R = vertex.guess;
      admm.solve(0, vertex.M, vertex.n, vertex.weight, R);
      const double exact = solveExactly(vertex);
      REQUIRE(vertex.objective(R) <= exact + 1e-12 * vertex.scale());
      REQUIRE(vertex.objective(R) == doctest::Approx(exact).epsilon(1e-8));
    }
  }
}

TEST_CASE("a warm exact step is no worse, gives the same bits and allocates nothing") {
  Noise noise;
  for (const double lambda : {0.2, 5.5}) {
    Vertex vertex = surfaceVertex(noise, lambda, 1);
    Vec3 u = Vec3::Zero();
    for (int step = 0; step < 50; ++step) {
      vertex.M += 0.05 * noise.matrix();
      Mat3 first = vertex.guess, second = vertex.guess;
      Vec3 sameU = u;
      const long before = testing::allocationCount();
      CubicExact::solveCertified(vertex.M, vertex.n, vertex.weight, u, first);
      REQUIRE(testing::allocationCount() == before);
      CubicExact::solveCertified(vertex.M, vertex.n, vertex.weight, sameU, second);
      REQUIRE(first == second);
      REQUIRE(vertex.objective(first) >= vertex.objective(vertex.guess) - 1e-12 * vertex.scale());
      vertex.guess = first;
    }
  }
}
