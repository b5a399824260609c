#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <limits>

#include "linear/constrained_quadratic.h"
#include "support/allocations.h"
#include "support/rows.h"
#include "support/systems.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

struct Held {
  std::vector<Index> rows;
  std::vector<RowPlane> planes;
};

/// The planes of rows that are not held anyway.
std::vector<RowPlane> planesOfOthers(const Held& held) {
  std::vector<RowPlane> planes = held.planes;
  std::erase_if(planes, [&](const RowPlane& plane) {
    return std::find(held.rows.begin(), held.rows.end(), plane.row) != held.rows.end();
  });
  return planes;
}

/// The minimum with the constraints, from the dense system of its first-order conditions; multipliers of planes given
/// twice share.
Points denseMinimum(const SparseMatrix& A, const Points& B, const Points& start, const Held& held) {
  const Index n = static_cast<Index>(A.rows()), unknowns = 3 * n;
  std::vector<RowPlane> planes = planesOfOthers(held);
  for (const Index row : held.rows) {
    for (int c = 0; c < 3; ++c) planes.push_back({row, Vec3::Unit(c), start(row, c)});
  }
  const Index all = unknowns + static_cast<Index>(planes.size());
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(all, all);
  Scalars rhs(all);
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < n; ++j) K.block<3, 3>(3 * i, 3 * j).diagonal().setConstant(A.coeff(i, j));
    rhs.segment<3>(3 * i) = B.row(i).transpose();
  }
  for (std::size_t p = 0; p < planes.size(); ++p) {
    const Index row = unknowns + static_cast<Index>(p);
    K.block<1, 3>(row, 3 * planes[p].row) = planes[p].normal.transpose();
    K.block<3, 1>(3 * planes[p].row, row) = planes[p].normal;
    rhs[row] = planes[p].offset;
  }
  const Scalars x = K.completeOrthogonalDecomposition().solve(rhs);
  Points X(n, 3);
  for (Index i = 0; i < n; ++i) X.row(i) = x.segment<3>(3 * i).transpose();
  return X;
}

void solve(const SparseMatrix& A, const Points& B, const Held& held, ConstrainedQuadratic& quadratic, Points& X) {
  std::vector<HeldRow> onPlanes;
  REQUIRE(joinPlanes(planesOfOthers(held), onPlanes).ok());
  const Index n = static_cast<Index>(A.rows());
  satisfyPlanes(onPlanes, X);
  for (int repetition = 0; repetition < 5; ++repetition) {
    LaneRows moves = toRows(B - A * X);
    moves.resize(ConstrainedQuadratic::paddedRows(n));
    const long before = allocationCount();
    quadratic.correct(moves);
    CHECK(allocationCount() == before);
    X += toPoints(moves, n);
    satisfyPlanes(onPlanes, X);
  }
}

/// Compares with the dense minimum, and the constraints with what they say.
void check(const SparseMatrix& A, const Held& held, Noise& noise, const Ordering& ordering = {}) {
  const Index n = static_cast<Index>(A.rows());
  ConstrainedQuadratic quadratic;
  REQUIRE(quadratic.prepare(A, held.rows, ordering, held.planes).ok());
  const Points B = randomPoints(n, noise), start = randomPoints(n, noise);
  Points X = start;
  solve(A, B, held, quadratic, X);
  const Points expected = denseMinimum(A, B, start, held);
  // Residuals come in single precision: across slanted planes the force that holds a row is rounded with what moves it.
  const bool slanted = std::any_of(held.planes.begin(), held.planes.end(),
                                   [](const RowPlane& plane) { return (plane.normal.array() != 0).count() > 1; });
  CHECK((X - expected).norm() <= (slanted ? 1e-7 : 1e-9) * expected.norm());
  for (const Index row : held.rows) CHECK(X.row(row) == start.row(row));
  for (const RowPlane& plane : held.planes) {
    if (std::find(held.rows.begin(), held.rows.end(), plane.row) != held.rows.end()) continue;
    CHECK(std::abs(plane.normal.dot(X.row(plane.row)) - plane.offset) <= 1e-13 * (1 + plane.normal.norm()));
  }
}

std::vector<RowPlane> onPlane(const std::vector<Index>& rows, const Vec3& normal, double offset) {
  std::vector<RowPlane> planes;
  for (const Index row : rows) planes.push_back({row, normal, offset});
  return planes;
}

std::vector<RowPlane> joined(std::vector<RowPlane> a, const std::vector<RowPlane>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

std::vector<Index> range(Index first, Index last) {
  std::vector<Index> rows;
  for (Index row = first; row < last; ++row) rows.push_back(row);
  return rows;
}

}  // namespace

TEST_CASE("single coordinates, planes, lines and points are held as the dense system has it") {
  Noise noise;
  const Index side = 6, n = side * side;
  const Vec3 slanted(1, -2, 0.5), other(0.3, 0.1, 1);
  Points coordinates(n, 3);
  for (Index i = 0; i < n; ++i) coordinates.row(i) << i / side, i % side, 0;
  const std::vector<Held> all = {
      {{}, {}},
      {{0, 35, 0}, {}},
      {{}, {{4, Vec3::UnitX(), 0.5}}},
      {{3}, {{4, Vec3::UnitX(), 0.5}, {4, Vec3::UnitZ(), -1}, {20, Vec3::UnitY(), 2}}},
      {{}, onPlane(range(0, 12), Vec3::UnitZ(), 0.25)},
      {{1}, onPlane(range(10, 22), slanted, 0.25)},
      // Rows 18 to 21 are on a line, row 7 is a point.
      {{1}, joined(onPlane(range(10, 22), slanted, 0.25), onPlane(range(18, 30), other, -1))},
      {{30}, joined(onPlane({7, 8}, slanted, 1), joined(onPlane({7}, other, 2), onPlane({7, 9}, Vec3::UnitX(), 3)))},
      {{}, joined(onPlane({2, 3}, slanted, 1), onPlane({2}, -3 * slanted, -3))},  // the same plane, turned and longer
      {{5, 6}, onPlane({5, 6}, slanted, 9)},                                      // rows that are held stay
      {{}, onPlane(range(0, n), slanted, 0.1)},
      {{}, joined(onPlane(range(0, n), slanted, 0.1), onPlane(range(0, n), other, 0.1))},
      {range(0, n), {}},
      {{},
       joined(onPlane(range(0, n), Vec3::UnitX(), 1),
              joined(onPlane(range(0, n), Vec3::UnitY(), 2), onPlane(range(0, n), Vec3::UnitZ(), 3)))},
  };
  for (std::size_t k = 0; k < all.size(); ++k) {
    CAPTURE(k);
    for (const Ordering& ordering : {Ordering{}, Ordering{&coordinates}, Ordering{.isOrdered = true}}) {
      check(matrixOn(n, gridEdges(side), noise), all[k], noise, ordering);
    }
  }
  for (int trial = 0; trial < 40; ++trial) {
    Held held;
    const Index count = pick(12, noise);
    for (Index k = 0; k < count; ++k) {
      const Index row = (10 * k + pick(3, noise)) % n;
      const Vec3 normal = noise.direction() * (1 + pick(5, noise));
      held.planes.push_back({row, normal, noise()});
    }
    if (trial % 2) held.rows = {pick(n, noise), pick(n, noise)};
    check(matrixOn(n, randomEdges(n, 3 * n, noise), noise), held, noise);
  }
}

TEST_CASE("planes that hold every direction make a Laplacian definite, others do not") {
  Noise noise;
  const Index n = 40;
  SparseMatrix L(n, n);
  for (const auto& [i, j] : path(n)) {
    L.coeffRef(i, i) += 1, L.coeffRef(j, j) += 1;
    L.coeffRef(i, j) -= 1, L.coeffRef(j, i) -= 1;
  }
  L.makeCompressed();
  check(L, {{}, {{0, Vec3::UnitX(), 1}, {15, Vec3(0, 1, 0.2), 1}, {n - 1, Vec3(0.1, 0, 1), 1}}}, noise);
  ConstrainedQuadratic quadratic;
  CHECK(quadratic.prepare(L, {}, {}, onPlane({0, 7, 20}, Vec3(1, 1, 0), 1)).code == Code::numericalFailure);
  CHECK(quadratic.prepare(L, {}, {}, {}).code == Code::numericalFailure);
  CHECK(quadratic.prepare(L, {3}, {}, onPlane({0, 7, 20}, Vec3(1, 1, 0), 1)).ok());
}

TEST_CASE("planes that exclude each other, or have no direction, are refused by the row") {
  Noise noise;
  const SparseMatrix A = matrixOn(20, path(20), noise);
  const auto refused = [&](const std::vector<RowPlane>& planes) {
    ConstrainedQuadratic quadratic;
    const Status status = quadratic.prepare(A, {1}, {}, joined(onPlane({3, 4}, Vec3::UnitX(), 1), planes));
    CHECK((status.ok() || status.code == Code::badPlanes));
    return status.element.index;
  };
  CHECK(refused({}) == -1);
  CHECK(refused({{4, Vec3::UnitX(), 1.001}}) == 4);
  CHECK(refused({{4, Vec3(-2, 0, 0), -2}}) == -1);
  CHECK(refused({{4, Vec3(-2, 0, 0), 2}}) == 4);
  CHECK(refused({{3, Vec3::UnitY(), 1}, {3, Vec3(1, 1, 0), 2}}) == -1);   // three planes through a line
  CHECK(refused({{3, Vec3::UnitY(), 1}, {3, Vec3(1, 1, 0), 2.1}}) == 3);  // and past it
  CHECK(refused({{3, Vec3::UnitY(), 1}, {3, Vec3::UnitZ(), 0}, {3, Vec3(1, 1, 1), 2}}) == -1);
  CHECK(refused({{3, Vec3::UnitY(), 1}, {3, Vec3::UnitZ(), 0}, {3, Vec3(1, 1, 1), 2.1}}) == 3);
  CHECK(refused({{8, Vec3::Zero(), 0}}) == 8);
  CHECK(refused({{9, Vec3(0, std::numeric_limits<double>::quiet_NaN(), 1), 0}}) == 9);
  CHECK(refused({{9, Vec3::UnitX(), std::numeric_limits<double>::infinity()}}) == 9);
}

TEST_CASE("with planes, too, preparing in slices gives the same bits, and again after a refusal") {
  Noise noise;
  const TriangleMesh mesh = bent(sphere(4));
  const Index n = mesh.vertexCount();
  const SparseMatrix A = matrixOn(n, edgesOf(mesh), noise);
  const std::vector<RowPlane> planes =
      joined(onPlane(range(100, 400), Vec3(1, 2, 3), 0.1), onPlane(range(600, 610), Vec3::UnitX(), 0));
  ConstrainedQuadratic whole, sliced;
  REQUIRE(whole.prepare(A, {5}, {.isOrdered = true}, planes).ok());
  CHECK(sliced.prepare(A, {5}, {}, joined(planes, {{600, Vec3::UnitX(), 1}})).code == Code::badPlanes);
  sliced.beginPrepare(A, {5}, {.isOrdered = true}, planes);
  double before = 0, share = 0;
  for (int slices = 0; share < 1; ++slices) {
    REQUIRE(slices < 1000000);
    REQUIRE(sliced.prepareNext(share, 1e4).ok());
    CHECK(share >= before);
    before = share;
  }
  LaneRows moves = toRows(randomPoints(n, noise));
  moves.resize(ConstrainedQuadratic::paddedRows(n));
  LaneRows others = moves;
  whole.correct(moves);
  sliced.correct(others);
  CHECK(toPoints(moves, n) == toPoints(others, n));
}
