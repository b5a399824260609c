#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <functional>
#include <limits>
#include <set>

#include "linear/dense_front.h"
#include "linear/elimination_tree.h"
#include "linear/sparse_cholesky.h"
#include "linear/supernodes.h"
#include "support/allocations.h"
#include "support/rows.h"
#include "support/systems.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

using Permutation = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, Index>;

SparseMatrix renumbered(const SparseMatrix& A, const Permutation& newOf) {
  SparseMatrix result;
  result = A.twistedBy(newOf);
  return result;
}

void checkSolves(const SparseMatrix& A, Noise& noise, const Ordering& ordering = {}) {
  const Points X = randomPoints(static_cast<Index>(A.rows()), noise);
  SparseCholesky cholesky;
  cholesky.analyze(A, ordering);
  REQUIRE(cholesky.factorize(A).ok());
  Points solution = A * X;
  const long before = allocationCount();
  cholesky.solve(solution);
  CHECK(allocationCount() == before);
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
    checkSolves(matrixOn(n, randomEdges(n, n * (1 + trial % 4), noise), noise), noise);
    checkSolves(matrixOn(n, randomTree(n, noise), noise), noise);
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
    // Columns of garbage stand for the padding: nothing of it may get in.
    constexpr double kGarbage = std::numeric_limits<double>::quiet_NaN();
    Eigen::MatrixXd padded = Eigen::MatrixXd::Constant(height, columns + kFrontPadding, kGarbage);
    auto panel = padded.leftCols(columns);
    panel = A.leftCols(columns);
    for (Index first = 0; first < columns; first += kFrontBlock) {
      REQUIRE(factorPanelBlock(panel.data(), height, columns, first));
    }

    const Eigen::MatrixXd corner = A.topLeftCorner(columns, columns);
    const Eigen::MatrixXd L11 = corner.llt().matrixL();
    const Eigen::MatrixXd inverse11 = L11.inverse();
    const Eigen::MatrixXd L21 = A.bottomLeftCorner(height - columns, columns) * inverse11.transpose();
    const Eigen::MatrixXd lower = panel.topRows(columns).triangularView<Eigen::Lower>();
    CHECK((lower - L11).norm() < 1e-12 * L11.norm());
    CHECK((panel.bottomRows(height - columns) - L21).norm() < 1e-12 * (1 + L21.norm()));

    Eigen::MatrixXd paddedInverse = Eigen::MatrixXd::Constant(height, columns + kFrontPadding, kGarbage);
    Eigen::MatrixXd scratch = Eigen::MatrixXd::Constant(columns, columns + kFrontPadding, kGarbage);
    const auto inverse = paddedInverse.leftCols(columns);
    beginInverse(panel.data(), paddedInverse.data(), height, columns);
    for (Index end = columns; end > 0; end -= kFrontBlock) {
      invertPanelBlock(panel.data(), paddedInverse.data(), scratch.data(), height, columns, end);
    }
    CHECK((inverse.topRows(columns) - inverse11).norm() < 1e-12 * inverse11.norm());
    CHECK((inverse.bottomRows(height - columns) + L21 * inverse11).norm() < 1e-12);
  }
}

TEST_CASE("right-hand sides of any number and storage are solved alike, three by three to the bit") {
  Noise noise;
  const Index n = 13 * 13;
  const SparseMatrix A = matrixOn(n, gridEdges(13), noise);
  SparseCholesky cholesky;
  cholesky.analyze(A);
  REQUIRE(cholesky.factorize(A).ok());
  for (const Index count : {0, 1, 2, 3, 4, 9, 24, 25, 77}) {
    CAPTURE(count);
    const Eigen::MatrixXd B = randomMatrix(n, count, noise);
    Eigen::MatrixXd X = B;
    cholesky.solve(X);
    if (count > 0) CHECK((A * X - B).norm() < 1e-5 * B.norm());
    RowMajor rows = B;
    const long before = allocationCount();
    cholesky.solve(rows);
    CHECK(allocationCount() == before);
    CHECK(rows == X);
    for (Index first = 0; first + 3 <= count; first += 3) {
      Points three = B.middleCols(first, 3);
      cholesky.solve(three);
      CHECK(three == X.middleCols(first, 3));
    }
    Eigen::MatrixXd some = B;  // every second column, where it is
    if (count % 2 == 0) {
      using Strided = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
      cholesky.solve(Strided(some.data(), n, count / 2, Eigen::OuterStride<>(2 * n)));
      for (Index c = 0; c < count; ++c) CHECK((some.col(c) - (c % 2 ? B : X).col(c)).norm() <= 1e-6 * B.norm());
    }
  }
}

TEST_CASE("right-hand sides in rows of their own are solved where they are, others of any number too") {
  Noise noise;
  const Index n = 60;
  const SparseMatrix A = matrixOn(n, randomEdges(n, 150, noise), noise);
  std::vector<Index> rowOf(n);
  for (Index i = 0; i < n; ++i) rowOf[i] = 2 * (n - i);  // row 0 is spare, every other one somebody else's
  SparseCholesky plain, placed;
  plain.analyze(A);
  placed.beginAnalyze(A, {}, rowOf, 0);
  while (placed.analyzeNext() < 1) {
  }
  REQUIRE(plain.factorize(A).ok());
  REQUIRE(placed.factorize(A).ok());
  Points B = randomPoints(n, noise);
  LaneRows rows(2 * n + 1, {7, 7, 7, 7});
  const LaneRows given = toRows(B);
  for (Index i = 0; i < n; ++i) rows[rowOf[i]] = given[i];
  placed.solve(rows.data());
  Points X = B;
  plain.solve(X);
  for (Index i = 0; i < n; ++i) {
    CHECK(Vec3(rows[rowOf[i]].x, rows[rowOf[i]].y, rows[rowOf[i]].z) == X.row(i).transpose());
    CHECK(rows[rowOf[i] - 1].x == 7);
  }
  placed.solve(B);
  CHECK(B == X);
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

TEST_CASE("systems in blocks: any pattern inside them, supernodes in whole blocks, cut in space or not") {
  Noise noise;
  for (const Index blockSize : {2, 3, 9}) {
    for (const Index side : {1, 2, 6, 13}) {
      const Index n = side * side;
      const SparseMatrix A = matrixOn(n, gridEdges(side), noise, blockSize);
      Points coordinates(n, 3);
      for (Index i = 0; i < n; ++i) coordinates.row(i) << i / side, i % side, 0;
      for (const Points* given : {static_cast<const Points*>(nullptr), static_cast<const Points*>(&coordinates)}) {
        const Ordering ordering{given, blockSize};
        const Supernodes supernodes = analyzeSupernodes(A, ordering);
        for (const Index start : supernodes.columnStart) CHECK(start % blockSize == 0);
        checkSolves(A, noise, ordering);
      }
    }
  }
  const Index side = 53, n = side * side;  // large enough to be cut in space
  const SparseMatrix large = matrixOn(n, gridEdges(side), noise, 9);
  Points coordinates(n, 3);
  for (Index i = 0; i < n; ++i) coordinates.row(i) << i / side, i % side, 0;
  checkSolves(large, noise, {&coordinates, 9});
}

TEST_CASE("an order that is known is kept") {
  Noise noise;
  const Index side = 12, n = side * side;
  const SparseMatrix A = matrixOn(n, gridEdges(side), noise);
  const Graph graph = graphOf(A);
  const std::vector<Index> order = eliminationTree(graph, minimumDegreeOrder(graph)).order;  // as its tree has it
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, Index> byOrder(n);  // from a node to its position
  for (Index i = 0; i < n; ++i) byOrder.indices()[order[i]] = i;
  SparseMatrix ordered;
  ordered = A.twistedBy(byOrder);
  const Supernodes supernodes = analyzeSupernodes(ordered, {.isOrdered = true});
  for (Index i = 0; i < n; ++i) CHECK(supernodes.newOf[i] == i);
  CHECK(supernodes.rows.size() == analyzeSupernodes(A).rows.size());
  checkSolves(ordered, noise, {.isOrdered = true});
  checkSolves(A, noise, {.isOrdered = true});  // though it is not
}

TEST_CASE("kept unknowns are left with their Schur complement, and the rest is solved around them") {
  Noise noise;
  const auto check = [&](const SparseMatrix& A, Index blockSize, Index kept, bool isOrdered) {
    CAPTURE(A.rows());
    CAPTURE(kept);
    const Index n = static_cast<Index>(A.rows()), left = kept * blockSize, eliminated = n - left;
    SparseCholesky cholesky;
    cholesky.analyze(A, {.blockSize = blockSize, .isOrdered = isOrdered, .kept = kept});
    REQUIRE(cholesky.factorize(A).ok());
    const Eigen::MatrixXd dense(A);
    const Eigen::MatrixXd schur = dense.inverse().bottomRightCorner(left, left).inverse();
    const Eigen::MatrixXd lower(cholesky.takeSchurComplement());
    REQUIRE(lower.rows() == left);
    CHECK((Eigen::MatrixXd(lower.selfadjointView<Eigen::Lower>()) - schur).norm() <= 1e-12 * (1 + schur.norm()));

    const Points B = randomPoints(n, noise);
    LaneRows rows = toRows(B);
    rows.emplace_back();
    cholesky.forward(rows.data());
    const LaneRows inKept = toRows(schur.inverse() * toPoints(rows, n).bottomRows(left));
    std::copy_n(inKept.begin(), left, rows.begin() + eliminated);
    cholesky.backward(rows.data());
    const Points X = dense.inverse() * B;
    CHECK((toPoints(rows, n) - X).norm() <= 1e-5 * X.norm());
  };
  for (const bool isOrdered : {false, true}) {
    for (const Index kept : {1, 5, 40, 99, 100}) {
      check(matrixOn(100, gridEdges(10), noise), 1, kept, isOrdered);
      check(matrixOn(100, islands(100), noise), 1, kept, isOrdered);
      check(matrixOn(100, randomTree(100, noise), noise), 1, kept, isOrdered);
      check(matrixOn(100, randomEdges(100, 200, noise), noise, 3), 3, kept, isOrdered);
    }
  }
}

TEST_CASE("renumbering the unknowns renumbers the solution") {
  Noise noise;
  const Index n = 90;
  const SparseMatrix A = matrixOn(n, randomEdges(n, 250, noise), noise);
  Permutation renumber(n);
  renumber.setIdentity();
  for (Index i = n - 1; i > 0; --i) std::swap(renumber.indices()[i], renumber.indices()[pick(i + 1, noise)]);
  const Points B = randomPoints(n, noise);
  const auto solve = [](const SparseMatrix& system, Points rhs) {
    SparseCholesky cholesky;
    cholesky.analyze(system);
    REQUIRE(cholesky.factorize(system).ok());
    cholesky.solve(rhs);
    return rhs;
  };
  const Points X = solve(A, B);
  CHECK((solve(renumbered(A, renumber), renumber * B) - renumber * X).norm() < 1e-5 * X.norm());
}

TEST_CASE("a factorization over an older one has the bits of a fresh one") {
  Noise noise;
  const SparseMatrix A = matrixOn(169, gridEdges(13), noise);
  SparseMatrix other = A * 2.5;
  for (Index i = 0; i < 169; ++i) other.coeffRef(i, i) += 1 + noise();
  const Points B = randomPoints(169, noise);
  SparseCholesky fresh, used;
  fresh.analyze(A), used.analyze(A);
  REQUIRE(used.factorize(other).ok());
  SparseMatrix indefinite = A;
  indefinite.coeffRef(80, 80) = -1;
  CHECK(!used.factorize(indefinite).ok());
  REQUIRE(used.factorize(other, true).ok());
  const long before = allocationCount();
  REQUIRE(used.factorize(A, true).ok());
  CHECK(allocationCount() == before);
  REQUIRE(fresh.factorize(A).ok());
  Points X = B, Y = B;
  fresh.solve(X), used.solve(Y);
  CHECK(X == Y);
}

TEST_CASE("semidefinite matrices and numbers that are not finite are a status") {
  Noise noise;
  for (const Edges& edges : {path(40), star(40), complete(40), gridEdges(6), randomTree(40, noise)}) {
    SparseMatrix A(40, 40);  // a graph Laplacian: constants are free, also on every island
    for (const auto& [i, j] : edges) {
      const double weight = 1 + pick(4, noise);  // whole, so that rows sum to zero exactly
      A.coeffRef(i, i) += weight, A.coeffRef(j, j) += weight;
      A.coeffRef(i, j) -= weight, A.coeffRef(j, i) -= weight;
    }
    A.makeCompressed();
    SparseCholesky cholesky;
    cholesky.analyze(A);
    CHECK(cholesky.factorize(A).code == Code::numericalFailure);
  }
  const SparseMatrix good = matrixOn(81, gridEdges(9), noise);
  SparseCholesky cholesky;
  cholesky.analyze(good);
  for (Index entry = 0; entry < good.nonZeros(); entry += 5) {
    for (const double value :
         {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN(), -1e300}) {
      SparseMatrix A = good;
      A.valuePtr()[entry] = value;
      const Status status = cholesky.factorize(A);
      if (status.ok()) continue;  // the upper triangle is not read
      CHECK(status.code == Code::numericalFailure);
    }
  }
  SparseMatrix A = good;
  A.coeffRef(7, 7) = std::numeric_limits<double>::quiet_NaN();
  CHECK(!cholesky.factorize(A).ok());
}

TEST_CASE("a random symmetric matrix is refused if and only if it is not definite") {
  Noise noise;
  int refused = 0;
  for (int trial = 0; trial < 120; ++trial) {
    const Index blockSize = 1 + trial % 3, n = 2 + trial % 12;
    SparseMatrix A = matrixOn(n, randomEdges(n, 2 * n, noise), noise, blockSize);
    for (Index i = 0; i < A.rows(); ++i) A.coeffRef(i, i) *= 0.85 + 0.3 * noise();
    const double smallest = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(Eigen::MatrixXd(A)).eigenvalues()[0];
    if (std::abs(smallest) < 1e-9) continue;
    SparseCholesky cholesky;
    cholesky.analyze(A, {nullptr, blockSize});
    const Status status = cholesky.factorize(A);
    CHECK(status.ok() == (smallest > 0));
    refused += !status.ok();
    if (!status.ok()) continue;
    Points X = randomPoints(static_cast<Index>(A.rows()), noise);
    cholesky.solve(X);
    CHECK(X.allFinite());
  }
  CHECK(refused > 20);
  CHECK(refused < 100);
}
