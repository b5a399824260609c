#pragma once

#include <vector>

#include "linear/graph.h"

namespace whittle {

/// The rows above the diagonal of each column of a symmetric matrix, after renumbering: all that symbolic analysis reads.
struct UpperPattern {
  std::vector<Index> start;  // #columns + 1
  std::vector<Index> rows;   // row < column, in no order

  Index size() const { return static_cast<Index>(start.size()) - 1; }
};

/// @param newOf new number of each node
UpperPattern upperPattern(const Graph& graph, const std::vector<Index>& newOf);

/// Parent of each column in the elimination tree (the first row below the diagonal of that column of L), −1 for roots.
std::vector<Index> eliminationTree(const UpperPattern& pattern);

/// Children before parents, subtrees in one piece: position → column.
std::vector<Index> postorder(const std::vector<Index>& parent);

/// Entries of each column of L, diagonal included.
std::vector<Index> columnCounts(const UpperPattern& pattern, const std::vector<Index>& parent);

}  // namespace whittle
