#include <doctest/doctest.h>

#include <Eigen/Dense>

#include "linear/constrained_quadratic.h"
#include "support/allocations.h"
#include "support/rows.h"
#include "support/shapes.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

/// A random sparse symmetric positive definite matrix.
SparseMatrix randomDefinite(Index n, Noise& noise) {
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
  for (Index entry = 0; entry < 3 * n; ++entry) {
    const Index i = static_cast<Index>((noise() + 1) / 2 * n) % n;
    const Index j = static_cast<Index>((noise() + 1) / 2 * n) % n;
    A(i, j) = A(j, i) = noise();
  }
  A.diagonal().array() = A.cwiseAbs().rowwise().sum().array() + 0.01;
  return A.sparseView();
}

Points randomPoints(Index n, Noise& noise) {
  Points points(n, 3);
  for (Index i = 0; i < n; ++i) points.row(i) << noise(), noise(), noise();
  return points;
}

}  // namespace

TEST_CASE("the Cholesky factorization solves random systems of every small size") {
  Noise noise;
  for (Index n = 1; n < 60; ++n) {
    const SparseMatrix A = randomDefinite(n, noise);
    const Points X = randomPoints(n, noise);
    Points rhs = A * X;
    SparseCholesky cholesky;
    cholesky.analyze(A);
    REQUIRE(cholesky.factorize(A).ok());
    cholesky.solve(rhs);
    CHECK((rhs - X).norm() < 1e-5 * X.norm());
  }
}

TEST_CASE("new values on a kept pattern") {
  Noise noise;
  SparseMatrix A = randomDefinite(40, noise);
  SparseCholesky cholesky;
  cholesky.analyze(A);
  REQUIRE(cholesky.factorize(A).ok());
  A *= 3;
  REQUIRE(cholesky.factorize(A).ok());
  Points rhs = A * Points::Ones(40, 3);
  cholesky.solve(rhs);
  CHECK((rhs - Points::Ones(40, 3)).norm() < 1e-5);
}

TEST_CASE("an indefinite or singular matrix is a status, not a NaN") {
  Noise noise;
  SparseMatrix indefinite = randomDefinite(20, noise);
  indefinite.coeffRef(7, 7) = -1;
  SparseCholesky cholesky;
  cholesky.analyze(indefinite);
  CHECK(cholesky.factorize(indefinite).code == Code::numericalFailure);
  const SparseMatrix zero(4, 4);
  cholesky.analyze(zero);
  CHECK(cholesky.factorize(zero).code == Code::numericalFailure);
}

TEST_CASE("held rows stay and the rest minimises the quadratic") {
  Noise noise;
  const Index n = 30;
  const SparseMatrix A = randomDefinite(n, noise);
  const Points B = randomPoints(n, noise);
  for (const std::vector<Index>& held : {std::vector<Index>{}, {4}, {0, 29, 4, 4}}) {
    ConstrainedQuadratic quadratic;
    const Points coordinates = randomPoints(n, noise);
    REQUIRE(quadratic.prepare(A, held, {held.empty() ? nullptr : &coordinates, 1, held.size() == 1}).ok());
    const Points start = randomPoints(n, noise);
    Points X = start;
    for (int repetition = 0; repetition < 4; ++repetition) {  // each takes six digits off the error
      LaneRows moves = toRows(B - A * X);
      moves.resize(ConstrainedQuadratic::paddedRows(n));
      const long before = testing::allocationCount();
      quadratic.correct(moves);
      CHECK(testing::allocationCount() == before);
      X += toPoints(moves, n);
    }
    Points residual = A * X - B;
    for (const Index row : held) {
      CHECK(X.row(row) == start.row(row));
      residual.row(row).setZero();
    }
    CHECK(residual.norm() < 1e-12 * (1 + B.norm()));
  }
}

TEST_CASE("everything held leaves nothing to solve") {
  Noise noise;
  const SparseMatrix A = randomDefinite(3, noise);
  ConstrainedQuadratic quadratic;
  REQUIRE(quadratic.prepare(A, {0, 1, 2}).ok());
  LaneRows moves = toRows(Points::Ones(3, 3));
  moves.resize(ConstrainedQuadratic::paddedRows(3));
  quadratic.correct(moves);
  CHECK(toPoints(moves, 3).isZero(0));
}
