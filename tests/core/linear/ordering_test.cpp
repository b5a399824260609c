#include <doctest/doctest.h>

#include <Eigen/OrderingMethods>
#include <algorithm>
#include <limits>
#include <numeric>
#include <set>

#include "linear/elimination_tree.h"
#include "linear/ordering.h"
#include "linear/vertex_cover.h"
#include "support/systems.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

bool isPermutation(std::vector<Index> order, Index n) {
  std::sort(order.begin(), order.end());
  std::vector<Index> all(n);
  std::iota(all.begin(), all.end(), 0);
  return order == all;
}

std::vector<Index> inverse(const std::vector<Index>& order) {
  std::vector<Index> positionOf(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) positionOf[order[i]] = static_cast<Index>(i);
  return positionOf;
}

/// Entries of the factor.
Index fill(const Graph& graph, const std::vector<Index>& order) {
  const std::vector<Index> counts = columnCounts(graph, eliminationTree(graph, order));
  return std::accumulate(counts.begin(), counts.end(), 0);
}

/// The rows below the diagonal of each column of L, ascending, by eliminating node after node.
std::vector<std::vector<Index>> eliminate(const Graph& graph, const std::vector<Index>& order) {
  const Index n = graph.size();
  const std::vector<Index> positionOf = inverse(order);
  std::vector<std::set<Index>> rows(n);
  for (Index node = 0; node < n; ++node) {
    for (Index p = graph.start[node]; p < graph.start[node + 1]; ++p) {
      const auto [column, row] = std::minmax(positionOf[node], positionOf[graph.neighbours[p]]);
      rows[column].insert(row);
    }
  }
  std::vector<std::vector<Index>> result(n);
  for (Index column = 0; column < n; ++column) {
    result[column].assign(rows[column].begin(), rows[column].end());
    for (std::size_t k = 1; k < result[column].size(); ++k) rows[result[column][0]].insert(result[column][k]);
  }
  return result;
}

Index entries(const std::vector<std::vector<Index>>& columns) {
  Index sum = 0;
  for (const std::vector<Index>& rows : columns) sum += static_cast<Index>(rows.size());
  return sum;
}

/// Eigen's approximate minimum degree.
std::vector<Index> plainMinimumDegree(const SparseMatrix& A) {
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, Index> order;
  Eigen::AMDOrdering<Index>()(A.selfadjointView<Eigen::Lower>(), order);
  return {order.indices().data(), order.indices().data() + order.size()};
}

}  // namespace

TEST_CASE("every order is a permutation, however odd the graph or its coordinates") {
  Noise noise;
  const auto check = [&](Index n, const Edges& edges) {
    const Graph graph = graphOf(matrixOn(n, edges, noise));
    REQUIRE(graph.size() == n);
    CHECK(isPermutation(minimumDegreeOrder(graph), n));
    Points coordinates = randomPoints(n, noise);
    CHECK(isPermutation(nestedDissectionOrder(graph, coordinates), n));
    CHECK(isPermutation(eliminationOrder(graph, &coordinates, 100000), n));  // by cuts
    for (Index i = 0; i < n; ++i) coordinates.row(i) << i, i % 3, 0;
    CHECK(isPermutation(nestedDissectionOrder(graph, coordinates), n));
    CHECK(isPermutation(nestedDissectionOrder(graph, Points::Constant(n, 3, 0.25)), n));
    if (n > 0) coordinates.row(n / 2).setConstant(std::numeric_limits<double>::quiet_NaN());
    CHECK(isPermutation(nestedDissectionOrder(graph, coordinates), n));
  };
  for (const Index n : {0, 1, 2, 3, 40, 121, 500}) {
    check(n, {});
    check(n, path(n));
    check(n, star(n));
    check(n, islands(n));
    check(n, randomTree(n, noise));
    check(n, randomEdges(n, 3 * n, noise));
  }
  check(130, complete(130));
  check(900, gridEdges(30));
}

TEST_CASE("minimum degree leaves no fill in trees, stars and cliques, in no numbering") {
  Noise noise;
  const auto check = [&](Index n, Edges edges) {
    const std::vector<Index> newOf = inverse(minimumDegreeOrder(graphOf(n, randomTree(n, noise))));  // any numbering
    for (auto& [a, b] : edges) a = newOf[a], b = newOf[b];
    const Graph graph = graphOf(n, edges);
    CHECK(fill(graph, minimumDegreeOrder(graph)) == n + static_cast<Index>(edges.size()));
  };
  for (const Index n : {1, 2, 17, 400}) {
    check(n, {});
    check(n, path(n));
    check(n, star(n));
    check(n, islands(n));
    check(n, randomTree(n, noise));
  }
  check(60, complete(60));
  // A strip of triangles.
  Edges strip = path(300);
  for (Index i = 2; i < 300; ++i) strip.emplace_back(i - 2, i);
  check(300, strip);
}

TEST_CASE("minimum degree leaves about as little fill as Eigen's") {
  Noise noise;
  const auto check = [&](Index n, const Edges& edges, double most) {
    const SparseMatrix A = matrixOn(n, edges, noise);
    const Graph graph = graphOf(A);
    CHECK(fill(graph, minimumDegreeOrder(graph)) < most * fill(graph, plainMinimumDegree(A)));
  };
  for (const TriangleMesh& mesh : {sphere(3), bent(sphere(4)), sphere(5), grid(40), torus(40)}) {
    check(mesh.vertexCount(), edgesOf(mesh), 1.03);
  }
  check(900, gridEdges(30), 1.03);
  check(600, randomEdges(600, 1800, noise), 1.03);
}

TEST_CASE("minimum degree puts nodes of very many neighbours last") {
  Noise noise;
  Edges edges = gridEdges(40);
  for (Index i = 1; i < 1600; ++i)
    edges.emplace_back(i % 2 ? 700 : 900, i % 2 ? (i == 700 ? 0 : i) : (i == 900 ? 0 : i));
  const std::vector<Index> order = minimumDegreeOrder(graphOf(matrixOn(1600, edges, noise)));
  CHECK(order[1598] == 700);
  CHECK(order[1599] == 900);
}

TEST_CASE("no coordinates, or too few of them, mean minimum degree") {
  Noise noise;
  const Graph graph = graphOf(matrixOn(400, gridEdges(20), noise));
  const Points few = Points::Zero(7, 3);
  CHECK(eliminationOrder(graph, nullptr, 1000) == eliminationOrder(graph));
  CHECK(eliminationOrder(graph, &few, 1000) == eliminationOrder(graph));
}

TEST_CASE("nested dissection leaves less fill than minimum degree on closed meshes, and hardly more on a small grid") {
  const auto ratio = [](const TriangleMesh& mesh) {
    const Graph graph = graphOf(mesh.vertexCount(), edgesOf(mesh));
    const double dissected = fill(graph, nestedDissectionOrder(graph, mesh.positions));
    return dissected / fill(graph, minimumDegreeOrder(graph));
  };
  CHECK(ratio(sphere(5)) < 0.95);
  CHECK(ratio(bent(sphere(4))) < 0.95);
  CHECK(ratio(grid(60)) < 1.05);
}

TEST_CASE("an elimination tree and its counts are those of elimination itself, from subtree to subtree") {
  Noise noise;
  const auto check = [&](Index n, const Edges& edges) {
    const Graph graph = graphOf(matrixOn(n, edges, noise));
    const std::vector<Index> order = minimumDegreeOrder(graphOf(n, randomTree(n, noise)));  // any order
    const EliminationTree tree = eliminationTree(graph, order);
    CHECK(isPermutation(tree.order, n));
    CHECK(tree.positionOf == inverse(tree.order));
    const std::vector<std::vector<Index>> given = eliminate(graph, order), sorted = eliminate(graph, tree.order);
    CHECK(entries(given) == entries(sorted));
    std::vector<Index> parent, counts;
    for (Index column = 0; column < n; ++column) {
      counts.push_back(1 + static_cast<Index>(sorted[column].size()));
      parent.push_back(sorted[column].empty() ? -1 : sorted[column].front());
    }
    CHECK(tree.parent == parent);
    CHECK(columnCounts(graph, tree) == counts);
    // Each column comes right after the last of its children, if it has any.
    for (Index column = 0; column + 1 < n; ++column) {
      const bool isLeaf = std::find(parent.begin(), parent.end(), column + 1) == parent.end();
      CHECK((isLeaf || parent[column] == column + 1));
    }
  };
  for (const Index n : {1, 2, 30, 90}) {
    check(n, {});
    check(n, path(n));
    check(n, star(n));
    check(n, islands(n));
    check(n, randomTree(n, noise));
    check(n, randomEdges(n, 2 * n, noise));
  }
  check(40, complete(40));
  check(100, gridEdges(10));
}

TEST_CASE("the graph of a matrix in blocks joins nodes once") {
  Noise noise;
  const SparseMatrix A = matrixOn(30, gridEdges(5), noise, 3);
  const Graph graph = graphOf(A, 3), expected = graphOf(30, gridEdges(5));
  CHECK(graph.start == expected.start);
}

TEST_CASE("a vertex cover touches every edge and is as small as any") {
  Noise noise;
  VertexCover cover;
  for (int trial = 0; trial < 300; ++trial) {
    const Index leftCount = pick(8, noise), rightCount = 1 + pick(8, noise);
    std::vector<Index> start = {0}, neighbours;
    std::vector<unsigned> reach(leftCount, 0);
    for (Index left = 0; left < leftCount; ++left) {
      for (Index right = 0; right < rightCount; ++right) {
        if (pick(4, noise) > trial % 4) continue;
        neighbours.push_back(right);
        reach[left] |= 1u << right;
      }
      start.push_back(static_cast<Index>(neighbours.size()));
    }
    const Index size = cover.find(start, neighbours, rightCount);

    Index counted = 0;
    for (Index left = 0; left < leftCount; ++left) {
      counted += cover.leftCovered(left);
      if (cover.leftCovered(left)) continue;
      for (Index p = start[left]; p < start[left + 1]; ++p) CHECK(cover.rightCovered(neighbours[p]));
    }
    for (Index right = 0; right < rightCount; ++right) counted += cover.rightCovered(right);
    CHECK(counted == size);
    Index smallest = leftCount;  // by trying all choices on the left
    for (unsigned chosen = 0; chosen < 1u << leftCount; ++chosen) {
      unsigned right = 0;
      for (Index left = 0; left < leftCount; ++left) right |= chosen >> left & 1 ? 0 : reach[left];
      smallest = std::min(smallest, __builtin_popcount(chosen) + __builtin_popcount(right));
    }
    CHECK(size == smallest);
  }
}
