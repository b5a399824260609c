#include "linear/graph.h"

#include <algorithm>
#include <numeric>

namespace whittle {

namespace {

/// @param forEachEdge calls its argument with both ends of every edge, each time in the same order
template <typename ForEachEdge>
Graph assemble(Index nodes, const ForEachEdge& forEachEdge) {
  Graph graph;
  graph.start.assign(nodes + 1, 0);
  forEachEdge([&](Index a, Index b) { ++graph.start[a + 1], ++graph.start[b + 1]; });
  std::partial_sum(graph.start.begin(), graph.start.end(), graph.start.begin());
  graph.neighbours.resize(graph.start.back());
  std::vector<Index> next(graph.start.begin(), graph.start.end() - 1);
  forEachEdge([&](Index a, Index b) {
    graph.neighbours[next[a]++] = b;
    graph.neighbours[next[b]++] = a;
  });
  return graph;
}

}  // namespace

Graph graphOf(Index nodes, const std::vector<std::pair<Index, Index>>& edges) {
  return assemble(nodes, [&](auto&& visit) {
    for (const auto& [a, b] : edges) visit(a, b);
  });
}

Graph graphOf(const SparseMatrix& A, Index blockSize) {
  const Index nodes = static_cast<Index>(A.cols()) / blockSize;
  std::vector<Index> lastSeen(nodes);  // a block counts once, however many entries it has
  return assemble(nodes, [&](auto&& visit) {
    std::fill(lastSeen.begin(), lastSeen.end(), -1);
    for (Index column = 0; column < nodes * blockSize; ++column) {
      const Index node = column / blockSize;
      for (SparseMatrix::InnerIterator entry(A, column); entry; ++entry) {
        const Index other = static_cast<Index>(entry.row()) / blockSize;
        if (other <= node || lastSeen[other] == node) continue;
        lastSeen[other] = node;
        visit(node, other);
      }
    }
  });
}

}  // namespace whittle
