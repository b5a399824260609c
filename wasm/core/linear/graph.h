#pragma once

#include <utility>
#include <vector>

#include "base/sparse_matrix.h"

namespace whittle {

/// An undirected graph as adjacency arrays: the neighbours of node v are neighbours[start[v]] … neighbours[start[v + 1] − 1].
/// Each edge stands at both of its ends and once; no node is its own neighbour.
struct Graph {
  std::vector<Index> start;  // #nodes + 1
  std::vector<Index> neighbours;

  Index size() const { return start.empty() ? 0 : static_cast<Index>(start.size()) - 1; }
};

/// @param edges both ends of each, no edge twice
Graph graphOf(Index nodes, const std::vector<std::pair<Index, Index>>& edges);

/// The graph of a symmetric matrix whose unknowns come in blocks: `blockSize`·node + component. Two nodes are neighbours if
/// any of their components are coupled. Of A only the lower triangle is read, and of that only the pattern.
Graph graphOf(const SparseMatrix& A, Index blockSize = 1);

}  // namespace whittle
