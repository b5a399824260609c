#include <doctest/doctest.h>

#include "linear/constrained_quadratic.h"
#include "linear/ordering.h"
#include "linear/sparse_cholesky.h"
#include "support/rows.h"
#include "support/systems.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

constexpr double kOneGo = 1e300;

/// Drives slices to the end and says how many they were. Shares do not fall, and are 1 only in the end.
template <typename Next>
int drive(Next&& next) {
  double before = 0;
  for (int slices = 1;; ++slices) {
    const double share = next();
    REQUIRE(share >= before);
    REQUIRE(share <= 1);
    if (share == 1) return slices;
    before = share;
  }
}

struct Run {
  SparseCholesky cholesky;
  int analysis = 0, factorization = 0;
  Code code = Code::ok;
};

void run(const SparseMatrix& A, const Ordering& ordering, double work, Run& out) {
  out.cholesky.beginAnalyze(A, ordering);
  out.analysis = drive([&] { return out.cholesky.analyzeNext(work); });
  out.cholesky.beginFactorize(A);
  out.factorization = drive([&] {
    double share = -1;
    out.code = out.cholesky.factorizeNext(share, work).code;
    return share;
  });
}

}  // namespace

TEST_CASE("an order made in slices of any size is the one made in one go") {
  Noise noise;
  const TriangleMesh mesh = bent(sphere(5));
  const Graph graph = graphOf(mesh.vertexCount(), edgesOf(mesh));
  const Graph tangle = graphOf(matrixOn(900, randomEdges(900, 4000, noise), noise));  // no small separator cuts it
  const Points scattered = randomPoints(900, noise);
  const auto check = [](const Graph& given, const Points* coordinates, Index blockSize, int least) {
    const std::vector<Index> expected = eliminationOrder(given, coordinates, blockSize);
    for (const double work : {1.0, 3e5, kOneGo}) {
      EliminationOrdering ordering(given, coordinates, blockSize);
      const int slices = drive([&] { return ordering.next(work); });
      CHECK((work == kOneGo ? slices == 1 : slices > (work == 1 ? 20 : 1) * least));
      CHECK(ordering.take() == expected);
    }
  };
  check(graph, &mesh.positions, 100, 5);  // by cuts
  check(graph, nullptr, 1, 5);            // by minimum degree
  check(tangle, &scattered, 100, 1);
  const Graph none = graphOf(0, {});
  CHECK(eliminationOrder(none).empty());
}

TEST_CASE("a factorization in slices of any size has the bits of one in one go") {
  Noise noise;
  const TriangleMesh mesh = bent(sphere(4));
  struct System {
    SparseMatrix A;
    Ordering ordering;
  };
  const std::vector<System> systems = {
      {matrixOn(mesh.vertexCount(), edgesOf(mesh), noise), {}},
      {matrixOn(150, complete(150), noise), {}},  // a single front, cut within
      {matrixOn(60, gridEdges(7), noise, 3), {nullptr, 3}},
      {matrixOn(40, islands(40), noise), {.isOrdered = true}},
      {matrixOn(1, {}, noise), {}},
  };
  for (const System& system : systems) {
    const Eigen::MatrixXd B = randomMatrix(static_cast<Index>(system.A.rows()), 4, noise);
    Run whole;
    run(system.A, system.ordering, kOneGo, whole);
    REQUIRE(whole.code == Code::ok);
    CHECK(whole.factorization == 2);  // one for the memory
    Eigen::MatrixXd expected = B;
    whole.cholesky.solve(expected);
    for (const double work : {1.0, 5e4}) {
      Run sliced;
      run(system.A, system.ordering, work, sliced);
      REQUIRE(sliced.code == Code::ok);
      Eigen::MatrixXd X = B;
      sliced.cholesky.solve(X);
      CHECK(X == expected);
      if (system.A.rows() >= 150 && work == 1) CHECK(sliced.factorization > 12);
    }
  }
}

TEST_CASE("a factorization that fails, or is left in the middle, spoils nothing that comes after") {
  Noise noise;
  const SparseMatrix A = matrixOn(100, gridEdges(10), noise);
  SparseMatrix bad = A;
  bad.coeffRef(57, 57) = -1;
  Run out;
  run(A, {}, kOneGo, out);
  Eigen::MatrixXd B = randomMatrix(100, 3, noise), expected = B;
  out.cholesky.solve(expected);

  double share = 0;
  out.cholesky.beginFactorize(bad);
  Status status;
  while (share < 1) status = out.cholesky.factorizeNext(share, 1000);
  CHECK(status.code == Code::numericalFailure);

  out.cholesky.beginFactorize(A);
  for (int slice = 0; slice < 5; ++slice) REQUIRE(out.cholesky.factorizeNext(share, 1).ok());
  CHECK(share < 1);
  REQUIRE(out.cholesky.factorize(A).ok());
  Eigen::MatrixXd X = B;
  out.cholesky.solve(X);
  CHECK(X == expected);
}

TEST_CASE("a constrained quadratic is prepared in slices to the same bits") {
  Noise noise;
  const TriangleMesh mesh = bent(sphere(4));
  const Index n = mesh.vertexCount();
  const SparseMatrix A = matrixOn(n, edgesOf(mesh), noise);
  const Points B = randomPoints(n, noise);
  const auto corrections = [&](ConstrainedQuadratic& quadratic) {
    LaneRows rows = toRows(B);
    rows.resize(ConstrainedQuadratic::paddedRows(n));
    quadratic.correct(rows);
    return toPoints(rows, n);
  };
  for (const Ordering& ordering : {Ordering{}, Ordering{&mesh.positions}, Ordering{.isOrdered = true}}) {
    ConstrainedQuadratic whole, sliced;
    REQUIRE(whole.prepare(A, {3, 500, 3}, ordering).ok());
    sliced.beginPrepare(A, {3, 500, 3}, ordering);
    const int slices = drive([&] {
      double share = -1;
      REQUIRE(sliced.prepareNext(share, 1e4).ok());
      return share;
    });
    CHECK(slices > 20);
    CHECK(corrections(sliced) == corrections(whole));
  }
}
