#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <functional>
#include <set>

#include "linear/dense_front.h"
#include "linear/sparse_cholesky.h"
#include "support/allocations.h"
#include "support/shapes.h"

using namespace whittle;
using testing::Noise;

namespace {

using Edges = std::vector<std::pair<Index, Index>>;

/// A diagonally dominant matrix with random entries on the given edges.
SparseMatrix matrixOn(Index n, const Edges& edges, Noise& noise) {
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
  for (const auto& [i, j] : edges) A(i, j) = A(j, i) = noise();
  A.diagonal().array() = A.cwiseAbs().rowwise().sum().array() + 0.1;
  return A.sparseView();
}

Edges path(Index n) {
  Edges edges;
  for (Index i = 1; i < n; ++i) edges.emplace_back(i - 1, i);
  return edges;
}

Edges star(Index n) {
  Edges edges;
  for (Index i = 1; i < n; ++i) edges.emplace_back(0, i);
  return edges;
}

Edges complete(Index n) {
  Edges edges;
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < i; ++j) edges.emplace_back(i, j);
  }
  return edges;
}

Edges gridEdges(Index side) {
  Edges edges;
  for (Index r = 0; r < side; ++r) {
    for (Index c = 0; c < side; ++c) {
      if (c + 1 < side) edges.emplace_back(r * side + c, r * side + c + 1);
      if (r + 1 < side) edges.emplace_back(r * side + c, (r + 1) * side + c);
    }
  }
  return edges;
}

/// Several islands, some of a single unknown, numbered criss-cross.
Edges islands(Index n) {
  Edges edges;
  for (Index i = 7; i < n; ++i) {
    if (i % 5 != 0) edges.emplace_back(i - 7, i);
  }
  return edges;
}

void checkSolves(const SparseMatrix& A, Noise& noise) {
  Points X(A.rows(), 3);
  for (Index i = 0; i < X.rows(); ++i) X.row(i) << noise(), noise(), noise();
  SparseCholesky cholesky;
  cholesky.analyze(A);
  REQUIRE(cholesky.factorize(A).ok());
  Points solution = A * X;
  const long before = testing::allocationCount();
  cholesky.solve(solution);
  CHECK(testing::allocationCount() == before);
  CHECK((solution - X).norm() < 1e-5 * X.norm());
  Points correction = A * (X - solution);  // one refinement takes the single precision away
  cholesky.solve(correction);
  CHECK((solution + correction - X).norm() < 1e-10 * X.norm());
}

}  // namespace

TEST_CASE("systems of every shape are solved: paths, stars, full, grids, islands, random") {
  Noise noise;
  for (const Index n : {1, 2, 3, 5, 17, 64, 130}) {
    for (const auto& shape : std::vector<std::function<Edges(Index)>>{path, star, complete, islands}) {
      checkSolves(matrixOn(n, shape(n), noise), noise);
    }
  }
  for (const Index side : {4, 13, 30}) checkSolves(matrixOn(side * side, gridEdges(side), noise), noise);
  for (int trial = 0; trial < 60; ++trial) {
    const Index n = 20 + trial;
    Edges edges;
    for (Index e = 0; e < n * (1 + trial % 4); ++e) {
      const auto pick = [&] { return static_cast<Index>((noise() + 1) / 2 * n) % n; };
      const Index i = pick(), j = pick();
      if (i != j) edges.emplace_back(i, j);
    }
    checkSolves(matrixOn(n, edges, noise), noise);
  }
}

TEST_CASE("supernodes hold every entry that elimination fills, children before parents") {
  Noise noise;
  for (const Index side : {3, 8, 15}) {
    const SparseMatrix A = matrixOn(side * side, gridEdges(side), noise);
    const Supernodes supernodes = analyzeSupernodes(A);
    const Index n = side * side;

    std::vector<std::set<Index>> below(n);  // symbolic elimination by its definition
    for (Index column = 0; column < n; ++column) {
      for (SparseMatrix::InnerIterator entry(A, column); entry; ++entry) {
        const auto [low, high] = std::minmax(supernodes.newOf[entry.row()], supernodes.newOf[column]);
        if (low != high) below[low].insert(high);
      }
    }
    for (Index column = 0; column < n; ++column) {
      if (below[column].empty()) continue;
      const Index parent = *below[column].begin();
      for (const Index row : below[column]) {
        if (row != parent) below[parent].insert(row);
      }
    }

    CHECK(supernodes.columnStart.back() == n);
    for (Index s = 0; s < supernodes.count(); ++s) {
      const std::set<Index> rows(supernodes.rowsOf(s), supernodes.rowsOf(s) + supernodes.height(s));
      CHECK(rows.size() == static_cast<std::size_t>(supernodes.height(s)));
      CHECK(std::is_sorted(supernodes.rowsOf(s), supernodes.rowsOf(s) + supernodes.height(s)));
      if (supernodes.parent[s] >= 0) CHECK(supernodes.parent[s] > s);
      for (Index column = supernodes.columnStart[s]; column < supernodes.columnStart[s + 1]; ++column) {
        CHECK(rows.count(column) == 1);
        for (const Index row : below[column]) REQUIRE(rows.count(row) == 1);
      }
    }
  }
}

TEST_CASE("dense fronts: factor and inverse panels against Eigen") {
  Noise noise;
  for (const auto& [height, columns] : {std::pair{1, 1}, {5, 3}, {7, 7}, {60, 25}, {90, 49}, {50, 50}}) {
    Eigen::MatrixXd A(height, height);
    for (Index i = 0; i < height; ++i) {
      for (Index j = 0; j <= i; ++j) A(i, j) = A(j, i) = noise();
    }
    A.diagonal().array() += 2 * height;
    Eigen::MatrixXd panel = A.leftCols(columns);
    REQUIRE(factorPanel(panel.data(), height, columns));

    const Eigen::MatrixXd corner = A.topLeftCorner(columns, columns);
    const Eigen::MatrixXd L11 = corner.llt().matrixL();
    const Eigen::MatrixXd inverse11 = L11.inverse();
    const Eigen::MatrixXd L21 = A.bottomLeftCorner(height - columns, columns) * inverse11.transpose();
    const Eigen::MatrixXd lower = panel.topRows(columns).triangularView<Eigen::Lower>();
    CHECK((lower - L11).norm() < 1e-12 * L11.norm());
    CHECK((panel.bottomRows(height - columns) - L21).norm() < 1e-12 * (1 + L21.norm()));

    Eigen::MatrixXd inverse(height, columns), scratch(columns, columns);
    invertPanel(panel.data(), inverse.data(), scratch.data(), height, columns);
    CHECK((inverse.topRows(columns) - inverse11).norm() < 1e-12 * inverse11.norm());
    CHECK((inverse.bottomRows(height - columns) + L21 * inverse11).norm() < 1e-12);
  }
}

TEST_CASE("a pivot that is not positive is noticed wherever it is") {
  Noise noise;
  const Index side = 9;
  const SparseMatrix good = matrixOn(side * side, gridEdges(side), noise);
  SparseCholesky cholesky;
  cholesky.analyze(good);
  for (Index bad = 0; bad < side * side; bad += 7) {
    SparseMatrix A = good;
    A.coeffRef(bad, bad) = -0.5;
    CHECK(cholesky.factorize(A).code == Code::numericalFailure);
  }
  CHECK(cholesky.factorize(good).ok());  // and the next matrix is none the worse for it
}
