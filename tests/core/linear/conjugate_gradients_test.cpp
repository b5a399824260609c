#include <doctest/doctest.h>

#include <Eigen/SparseCholesky>
#include <limits>

#include "linear/sparse_cholesky.h"
#include "support/allocations.h"
#include "support/systems.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

/// The Laplacian of a mesh with a weight for each edge, kept definite by a little of the identity.
SparseMatrix laplacian(Index n, const Edges& edges, const std::vector<double>& weights) {
  std::vector<Eigen::Triplet<double, Index>> entries;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto [i, j] = edges[e];
    entries.emplace_back(i, i, weights[e]), entries.emplace_back(j, j, weights[e]);
    entries.emplace_back(i, j, -weights[e]), entries.emplace_back(j, i, -weights[e]);
  }
  for (Index i = 0; i < n; ++i) entries.emplace_back(i, i, 1e-3);
  SparseMatrix A(n, n);
  A.setFromTriplets(entries.begin(), entries.end());
  return A;
}

}  // namespace

TEST_CASE("a factor of the same matrix gives double precision in three iterations") {
  Noise noise;
  const TriangleMesh mesh = bent(sphere(3));
  const Edges edges = edgesOf(mesh);
  std::vector<SparseMatrix> systems = {laplacian(mesh.vertexCount(), edges, std::vector<double>(edges.size(), 1))};
  for (const Index n : {1, 2, 30, 100}) systems.push_back(matrixOn(n, randomEdges(n, 3 * n, noise), noise));
  systems.push_back(matrixOn(40, path(40), noise, 3));
  for (const SparseMatrix& A : systems) {
    SparseCholesky cholesky;
    cholesky.analyze(A);
    REQUIRE(cholesky.factorize(A).ok());
    const Points B = randomPoints(static_cast<Index>(A.rows()), noise);
    Points X = Points::Zero(A.rows(), 3);
    ConjugateGradients::Report report;
    REQUIRE(cholesky.solveRefined(A, B, X, {1e-14, 3}, &report).ok());
    CHECK(report.iterations <= 3);
    CHECK(report.residual < 1e-12);
    const Points expected = Eigen::SimplicialLDLT<SparseMatrix>(A).solve(B);
    CHECK((X - expected).norm() < 1e-12 * expected.norm());
  }
}

TEST_CASE("a factor with weights between half and twice the present ones still does") {
  Noise noise;
  const TriangleMesh mesh = sphere(4);
  const Index n = mesh.vertexCount();
  const Edges edges = edgesOf(mesh);
  std::vector<double> weights(edges.size(), 1);
  SparseCholesky cholesky;
  const SparseMatrix old = laplacian(n, edges, weights);
  cholesky.analyze(old);
  REQUIRE(cholesky.factorize(old).ok());
  for (double& w : weights) w = std::exp2(noise());
  const SparseMatrix A = laplacian(n, edges, weights);
  const Points B = randomPoints(n, noise);
  Points X = Points::Zero(n, 3);
  ConjugateGradients::Report report;
  REQUIRE(cholesky.solveRefined(A, B, X, {1e-6, 30}, &report).ok());
  CHECK(report.iterations <= 15);
  CHECK((B - A * X).norm() <= 2e-6 * B.norm());

  const long before = allocationCount();  // from here it goes on without new memory, and from where it was
  REQUIRE(cholesky.solveRefined(A, B, X, {1e-13, 60}, &report).ok());
  CHECK(allocationCount() == before);
  CHECK(report.iterations <= 30);
  const Points expected = Eigen::SimplicialLDLT<SparseMatrix>(A).solve(B);
  CHECK((X - expected).norm() < 1e-10 * expected.norm());
}

TEST_CASE("columns of any size, also zero ones, and the limit of iterations") {
  Noise noise;
  const SparseMatrix A = matrixOn(50, randomEdges(50, 120, noise), noise);
  SparseCholesky cholesky;
  cholesky.analyze(A);
  REQUIRE(cholesky.factorize(A).ok());
  Points B = randomPoints(50, noise);
  B.col(0) *= 1e-60;  // far below single precision
  B.col(1).setZero();
  B.col(2) *= 1e60;
  Points X = randomPoints(50, noise);
  X.col(0).setZero();
  ConjugateGradients::Report report;
  REQUIRE(cholesky.solveRefined(A, B, X, {1e-12, 10}, &report).ok());
  CHECK(report.residual < 1e-12);
  CHECK(X.col(1).isZero(0));
  const Points expected = Eigen::SimplicialLDLT<SparseMatrix>(A).solve(B);
  for (int c = 0; c < 3; ++c) CHECK((X - expected).col(c).norm() <= 1e-11 * expected.col(c).norm());

  const Points start = randomPoints(50, noise);
  X = start;
  B = randomPoints(50, noise);
  REQUIRE(cholesky.solveRefined(A, B, X, {1e-12, 0}, &report).ok());
  CHECK(report.iterations == 0);
  CHECK(report.residual > 0.1);
  CHECK(!report.reached);  // and it says so
  CHECK(X == start);
}

TEST_CASE("an indefinite matrix or numbers that are not finite are a status") {
  Noise noise;
  const SparseMatrix A = matrixOn(30, gridEdges(5), noise);
  SparseCholesky cholesky;
  cholesky.analyze(A);
  REQUIRE(cholesky.factorize(A).ok());
  const Points B = randomPoints(30, noise);
  ConjugateGradients::Report report;
  const auto code = [&](const SparseMatrix& system, const Points& rhs) {
    Points X = Points::Zero(30, 3);
    const Code result = cholesky.solveRefined(system, rhs, X, {1e-12, 40}, &report).code;
    CHECK(X.allFinite());
    return result;
  };
  CHECK(code(-A, B) == Code::numericalFailure);
  SparseMatrix bad = A;
  bad.coeffRef(12, 12) = -5;
  CHECK(code(bad, B) == Code::numericalFailure);
  for (const double value : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    bad.coeffRef(12, 12) = value;
    CHECK(code(bad, B) == Code::numericalFailure);
    Points badB = B;
    badB(3, 1) = value;
    CHECK(code(A, badB) == Code::numericalFailure);
  }
}

TEST_CASE("any number of right-hand sides, stored by rows or by columns, is refined to double precision") {
  Noise noise;
  const Index blockSize = 3, n = 40 * blockSize;
  const SparseMatrix A = matrixOn(40, randomEdges(40, 120, noise), noise, blockSize);
  SparseCholesky cholesky;
  cholesky.analyze(A, {nullptr, blockSize});
  REQUIRE(cholesky.factorize(A).ok());
  const Eigen::SimplicialLDLT<SparseMatrix> plain(A);
  for (const Index count : {0, 1, 2, 3, 4, 9, 24, 25, 100}) {
    CAPTURE(count);
    const Eigen::MatrixXd B = randomMatrix(n, count, noise), expected = plain.solve(B);
    Eigen::MatrixXd X = Eigen::MatrixXd::Zero(n, count);
    ConjugateGradients::Report report;
    REQUIRE(cholesky.solveRefined(A, B, X, {}, &report).ok());
    CHECK(report.reached);
    CHECK(report.iterations <= 3);
    for (Index c = 0; c < count; ++c) CHECK((B - A * X).col(c).norm() <= 1.01e-12 * B.col(c).norm());
    CHECK((X - expected).norm() <= 1e-11 * expected.norm());

    RowMajor rows = RowMajor::Zero(n, count);
    REQUIRE(cholesky.solveRefined(A, RowMajor(B), rows).ok());
    CHECK(rows == X);
    const long before = allocationCount();
    REQUIRE(cholesky.solveRefined(A, B, X).ok());
    CHECK(allocationCount() == before);
  }
}

TEST_CASE("a residual that rounding does not let be reached is said to be so") {
  const Index n = 400;  // a chain held at one end, its load smooth: ‖A‖ ‖x‖ / ‖b‖ is about n²
  SparseMatrix A(n, n);
  for (Index i = 0; i < n; ++i) {
    A.coeffRef(i, i) = i + 1 < n ? 2 : 1;
    if (i > 0) A.coeffRef(i, i - 1) = A.coeffRef(i - 1, i) = -1;
  }
  A.makeCompressed();
  SparseCholesky cholesky;
  cholesky.analyze(A);
  REQUIRE(cholesky.factorize(A).ok());
  const Scalars b = Scalars::Constant(n, 0.1);
  Scalars x = Scalars::Zero(n);
  ConjugateGradients::Report report;
  REQUIRE(cholesky.solveRefined(A, b, x, {1e-17, 500}, &report).ok());
  CHECK(!report.reached);
  CHECK(report.iterations < 100);  // nor does it go on in vain
  CHECK(report.residual == doctest::Approx((b - A * x).norm() / b.norm()).epsilon(0.1));
  REQUIRE(cholesky.solveRefined(A, b, x, {1e-10, 50}, &report).ok());
  CHECK(report.reached);
}
