#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "linear/elimination_tree.h"
#include "linear/nested_dissection.h"
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
  const UpperPattern pattern = upperPattern(graph, inverse(order));
  const std::vector<Index> counts = columnCounts(pattern, eliminationTree(pattern));
  return std::accumulate(counts.begin(), counts.end(), 0);
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
    CHECK(isPermutation(eliminationOrder(graph, &coordinates, 100000), n));  // by cuts, and then sorted by the tree
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

TEST_CASE("an elimination order is sorted by its own tree") {
  Noise noise;
  for (const Index blockSize : {1, 1000}) {
    const TriangleMesh mesh = sphere(3);
    const Graph graph = graphOf(mesh.vertexCount(), edgesOf(mesh));
    const std::vector<Index> order = eliminationOrder(graph, &mesh.positions, blockSize);
    const std::vector<Index> again = postorder(eliminationTree(upperPattern(graph, inverse(order))));
    CHECK(std::is_sorted(again.begin(), again.end()));
  }
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
