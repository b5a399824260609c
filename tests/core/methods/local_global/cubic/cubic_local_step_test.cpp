#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/rotation_fit.h"
#include "methods/local_global/cubic/cubic_admm.h"
#include "methods/local_global/cubic/cubic_exact.h"
#include "methods/local_global/cubic/cubic_search.h"
#include "support/allocations.h"
#include "support/shapes.h"

using namespace whittle;
using testing::Noise;

namespace {

struct Vertex : CubicVertex {
  Mat3 guess;

  /// What objectives are measured against.
  double scale() const { return M.norm() + weights.norm(); }
};

Vertex vertexOf(Noise& noise, const Mat3& M, double weight) {
  // Other weights on each axis now and then, and none.
  const Vec3 axes = noise() > 0 ? Vec3::Ones() : Vec3{1, 1 + noise(), noise() > 0.5 ? 0.0 : 1.0};
  return {{M, noise.direction(), weight * axes}, noise.rotation()};
}

/// Covariances of every awkward kind: random, reflected, of rank 2, 1 and 0, with equal singular values, tiny.
std::vector<Mat3> awkwardCovariances(Noise& noise) {
  std::vector<Mat3> matrices = {noise.matrix(), Mat3::Zero(), Mat3::Identity()};
  for (const Vec3& values : {Vec3(3, 2, 1), Vec3(3, 2, -1), Vec3(1, 1, 0), Vec3(1, 0, 0), Vec3(1, 1, -1),
                             Vec3(1, 0.3, -0.2999), Vec3(1, 1e-4, 1e-8), Vec3(1e-12, 1e-12, 0)}) {
    matrices.push_back(noise.withSingularValues(values));
  }
  return matrices;
}

/// A vertex of a surface at work: the tangent projector of a smooth neighbourhood, somewhat turned, bent and noisy.
Vertex surfaceVertex(Noise& noise, double lambda, double area) {
  Vertex vertex = vertexOf(noise, Mat3::Zero(), lambda * area);
  const Mat3 projector = Mat3::Identity() - vertex.n * vertex.n.transpose();
  const Vec3 axis = noise.direction();
  const Mat3 turn = Eigen::AngleAxisd(0.5 * noise(), axis).toRotationMatrix();
  vertex.M = area * (6 * projector * turn.transpose() + 0.3 * noise.matrix());
  vertex.guess = fitRotation(vertex.M);
  return vertex;
}

double solveExactly(const Vertex& vertex, bool* certified = nullptr) {
  Mat3 R = vertex.guess;
  Vec3 u = Vec3::Zero();
  const bool proved = CubicExact::solveCertified(vertex, u, R);
  if (certified) *certified = proved;
  REQUIRE((R.transpose() * R - Mat3::Identity()).norm() < 1e-12);
  REQUIRE(R.determinant() > 0);
  // u is a subgradient either way, which is what makes the certificate one.
  REQUIRE(u.cwiseAbs().maxCoeff() <= 1 + 1e-8);
  const Vec3 s = R * vertex.n;
  REQUIRE(vertex.regularizer(s) - vertex.weights.cwiseProduct(u).dot(s) <= 1e-7 * vertex.weights.norm());
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
    offer(Eigen::AngleAxisd(angle, noise.direction()).toRotationMatrix() * best);
  }
  return vertex.objective(best);
}

double minimisedDual(const Vertex& vertex, const Vec3& u) {
  const Mat3 M = vertex.pulled(u);
  return fitRotation(M).cwiseProduct(M.transpose()).sum();
}

}  // namespace

TEST_CASE("brute force never beats the exact step") {
  Noise noise;
  for (const double lambda : {0.01, 0.2, 1.0, 3.0, 4.5, 5.9}) {
    for (int trial = 0; trial < 8; ++trial) {
      for (const Mat3& M : awkwardCovariances(noise)) {
        const double weight = lambda * std::max(M.norm(), 1e-12) / 6;
        for (Vertex vertex :
             {vertexOf(noise, M, weight), vertexOf(noise, M, 1e-30), surfaceVertex(noise, lambda, 1e-9)}) {
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
      if (!CubicExact::solveCertified(vertex, u, R)) continue;
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
    const double searched = vertex.objective(searchCubic(PolyhedralVertex(vertex), noise.rotation()));
    REQUIRE(searched == doctest::Approx(exact).epsilon(1e-9));
  }
}

TEST_CASE("the exact step agrees with a tight ADMM") {
  Noise noise;
  for (const double lambda : {0.05, 0.2, 0.4, 1.0, 2.0}) {
    for (int trial = 0; trial < 30; ++trial) {
      const Vertex vertex = surfaceVertex(noise, lambda, 1e-3);
      const PolyhedralVertex general(vertex);
      const CubicAdmm admm(general.polyhedron, {1e-12, 1e-10, 1e-10, 20000});
      CubicAdmm::State state;
      Mat3 R = vertex.guess;
      const FanNormal normal{vertex.n, general.weight};
      admm.solve(vertex.M, {&normal, 1}, {&state, 1}, R);
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
      CubicExact::solveCertified(vertex, u, first);
      REQUIRE(testing::allocationCount() == before);
      CubicExact::solveCertified(vertex, sameU, second);
      REQUIRE(first == second);
      REQUIRE(vertex.objective(first) >= vertex.objective(vertex.guess) - 1e-12 * vertex.scale());
      vertex.guess = first;
    }
  }
}

namespace {

/// Four vertices as the product packs them: with the same share of their weight on each axis.
struct Packed {
  MatrixLanes M;
  FanLanes fan;
  Vec3 axes;
  QuaternionLanes rotations = identityRotations();

  explicit Packed(std::array<Vertex, 4>& vertices) : axes(vertices[0].weights / vertices[0].weights.maxCoeff()) {
    for (int lane = 0; lane < 4; ++lane) {
      Vertex& vertex = vertices[lane];
      const double weight = vertex.weights.maxCoeff();
      vertex.weights = weight * axes;
      setMatrix(M, lane, vertex.M);
      setVector(fan.n, lane, vertex.n);
      fan.weight[lane] = static_cast<float>(weight);
      setRotation(rotations, lane, vertex.guess);
    }
  }

  CubicLanes lanes() const { return {M, {&fan, 1}}; }
  VectorLanes weights() const {
    const auto along = [&](int axis) { return static_cast<float>(axes[axis]) * fan.weight; };
    return {along(0), along(1), along(2)};
  }
};

constexpr double kSingle = 3e-6;  // of an objective's scale

}  // namespace

TEST_CASE("four vertices in single precision reach what one reaches in double") {
  Noise noise;
  for (const double lambda : {0.05, 0.2, 0.4, 1.0, 2.0, 5.5}) {
    int certified = 0, count = 0;
    for (int trial = 0; trial < 200; ++trial) {
      std::array<Vertex, 4> vertices = {surfaceVertex(noise, lambda, 1e-4), surfaceVertex(noise, lambda, 1e-12),
                                        surfaceVertex(noise, lambda, 1e3), surfaceVertex(noise, lambda, 1)};
      Packed packed(vertices);
      VectorLanes u{splat(0), splat(0), splat(0)};
      QuaternionLanes climbed = packed.rotations;
      const LaneMask proved = climbLanes(packed.M, packed.fan.n, packed.weights(), LaneMask{}, u, climbed).certified;
      const FanLayout layout = FanLayout::ofSingles(4);
      CubicExact solver(packed.axes);
      solver.begin(layout);
      const Lanes regularizers = solver.solve(0, packed.lanes(), packed.rotations);
      for (int lane = 0; lane < 4; ++lane) {
        const Vertex& vertex = vertices[lane];
        const Mat3 R = rotationAt(packed.rotations, lane);
        const double exact = solveExactly(vertex);
        REQUIRE(std::abs(vertex.objective(R) - exact) <= kSingle * vertex.scale());
        REQUIRE(std::abs(regularizers[lane] - vertex.regularizer(R * vertex.n)) <= kSingle * vertex.scale());
        certified += proved[lane] != 0;
        ++count;
      }
    }
    if (lambda <= 2) CHECK(certified >= 0.97 * count);
  }
}

TEST_CASE("four awkward vertices are solved too") {
  Noise noise;
  for (int trial = 0; trial < 20; ++trial) {
    const std::vector<Mat3> matrices = awkwardCovariances(noise);
    for (std::size_t k = 0; k + 3 < matrices.size(); ++k) {
      std::array<Vertex, 4> vertices;
      for (int lane = 0; lane < 4; ++lane) {
        const Mat3& M = matrices[k + lane];
        vertices[lane] = vertexOf(noise, M, lane > 0 && lane == trial % 4 ? 0 : 0.3 * std::max(M.norm(), 1e-12));
      }
      Packed packed(vertices);
      const FanLayout layout = FanLayout::ofSingles(4);
      CubicExact solver(packed.axes);
      solver.begin(layout);
      solver.solve(0, packed.lanes(), packed.rotations);
      for (int lane = 0; lane < 4; ++lane) {
        const Mat3 R = rotationAt(packed.rotations, lane);
        REQUIRE(R.allFinite());
        REQUIRE(R.determinant() == doctest::Approx(1));
        if (vertices[lane].weights.isZero(0)) continue;
        REQUIRE(vertices[lane].objective(R) >= solveExactly(vertices[lane]) - kSingle * vertices[lane].scale());
      }
    }
  }
}
