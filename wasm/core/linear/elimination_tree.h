#pragma once

#include <vector>

#include "linear/graph.h"

namespace whittle {

/// The nodes of a graph in the order in which they are eliminated, and the tree of it. All that symbolic analysis
/// reads.
struct EliminationTree {
  std::vector<Index> order;       // position → node; children come before parents, subtrees in one piece
  std::vector<Index> positionOf;  // node → position
  std::vector<Index> parent;  // of each position, the first row below the diagonal of that column of L; −1 for roots

  Index size() const { return static_cast<Index>(order.size()); }
};

/// The elimination tree of nodes in any order (position → node). The order is changed to one that leaves the very same
/// fill and goes through the tree from subtree to subtree.
/// @param kept so many nodes stay the last ones and in their order: each is made the parent of the one before
EliminationTree eliminationTree(const Graph& graph, const std::vector<Index>& order, Index kept = 0);

/// Entries of each column of L, diagonal included (Gilbert, Ng and Peyton 1994), in time that hardly depends on how
/// many they are. Those of kept nodes are not counted right.
std::vector<Index> columnCounts(const Graph& graph, const EliminationTree& tree);

}  // namespace whittle
