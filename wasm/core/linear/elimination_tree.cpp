#include "linear/elimination_tree.h"

#include <utility>

#include "base/tiering.h"

namespace whittle {

namespace {

constexpr Index kNone = -1;

std::vector<Index> inverse(const std::vector<Index>& order) {
  std::vector<Index> positionOf(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) positionOf[order[i]] = static_cast<Index>(i);
  return positionOf;
}

/// Hangs the roots below which a node has neighbours under it.
/// @param ancestor shortcuts towards the root of what is built so far
WHITTLE_OWN_FUNCTION void hang(const Graph& graph, Index node, const Index* positionOf, Index* ancestor,
                               Index* parent) {
  const Index column = positionOf[node];
  for (Index p = graph.start[node]; p < graph.start[node + 1]; ++p) {
    Index v = positionOf[graph.neighbours[p]];
    if (v > column) continue;
    while (v != kNone && v != column) {
      const Index next = std::exchange(ancestor[v], column);
      if (next == kNone) parent[v] = column;
      v = next;
    }
  }
}

/// Children before parents, subtrees in one piece: new position → old one. From the end: a tree's root is the last of
/// its piece.
std::vector<Index> postorder(const std::vector<Index>& parent) {
  const Index n = static_cast<Index>(parent.size());
  std::vector<Index> size(n + 1, 1);  // of subtrees; the last is all of them
  for (Index v = 0; v < n; ++v) size[parent[v] == kNone ? n : parent[v]] += size[v];
  std::vector<Index> order(n);
  std::vector<Index>& end = size;  // of the piece that is left to a node's children, once its own is placed
  end[n] = n;
  for (Index v = n - 1; v >= 0; --v) {
    Index& left = end[parent[v] == kNone ? n : parent[v]];
    const Index last = left - 1;
    left -= end[v];
    order[last] = v;
    end[v] = last;
  }
  return order;
}

/// Finds the column counts as sums over subtrees: each row of L is a subtree, whose leaves and branchings are enough to
/// count it.
class ColumnCounter {
 public:
  ColumnCounter(const Graph& graph, const EliminationTree& tree)
      : graph_(graph), tree_(tree), first_(tree.size(), kNone), latestFirst_(tree.size(), kNone),
        latestLeaf_(tree.size(), kNone), ancestor_(tree.size()), counts_(tree.size()) {}

  std::vector<Index> count();

 private:
  void visit(Index column);
  Index root(Index v);

  const Graph& graph_;
  const EliminationTree& tree_;
  std::vector<Index> first_;        // of each subtree
  std::vector<Index> latestFirst_;  // by row: of the subtree below the last leaf
  std::vector<Index> latestLeaf_;   // by row
  std::vector<Index> ancestor_;     // shortcuts towards the last column above that was visited
  std::vector<Index> counts_;       // less those of the children, until the end
};

std::vector<Index> ColumnCounter::count() {
  const Index n = tree_.size();
  const std::vector<Index>& parent = tree_.parent;
  for (Index j = 0; j < n; ++j) {
    ancestor_[j] = j;
    counts_[j] += first_[j] == kNone;  // a leaf
    if (first_[j] == kNone) first_[j] = j;
    if (parent[j] == kNone) continue;
    if (first_[parent[j]] == kNone) first_[parent[j]] = first_[j];
    --counts_[parent[j]];
  }
  for (Index j = 0; j < n; ++j) visit(j);
  for (Index j = 0; j < n; ++j) {
    if (parent[j] != kNone) counts_[parent[j]] += counts_[j];
  }
  return std::move(counts_);
}

WHITTLE_OWN_FUNCTION void ColumnCounter::visit(Index column) {
  const Index node = tree_.order[column];
  for (Index p = graph_.start[node]; p < graph_.start[node + 1]; ++p) {
    const Index row = tree_.positionOf[graph_.neighbours[p]];
    if (row < column || first_[column] <= latestFirst_[row]) continue;  // no leaf of the row's subtree
    latestFirst_[row] = first_[column];
    ++counts_[column];
    const Index before = std::exchange(latestLeaf_[row], column);
    if (before != kNone) --counts_[root(before)];  // where the ways up from both leaves meet
  }
  if (tree_.parent[column] != kNone) ancestor_[column] = tree_.parent[column];
}

Index ColumnCounter::root(Index v) {
  while (ancestor_[v] != v) v = ancestor_[v] = ancestor_[ancestor_[v]];
  return v;
}

}  // namespace

EliminationTree eliminationTree(const Graph& graph, const std::vector<Index>& order, Index kept) {
  const Index n = graph.size();
  const std::vector<Index> given = inverse(order);
  std::vector<Index> parent(n, kNone), ancestor(n, kNone);
  for (const Index node : order) hang(graph, node, given.data(), ancestor.data(), parent.data());
  for (Index v = n - kept; v < n; ++v) parent[v] = v + 1 < n ? v + 1 : kNone;

  EliminationTree tree{postorder(parent), {}, std::vector<Index>(n)};
  const std::vector<Index> moved = inverse(tree.order);
  for (Index v = 0; v < n; ++v) tree.parent[moved[v]] = parent[v] == kNone ? kNone : moved[parent[v]];
  for (Index& place : tree.order) place = order[place];
  tree.positionOf = inverse(tree.order);
  return tree;
}

std::vector<Index> columnCounts(const Graph& graph, const EliminationTree& tree) {
  return ColumnCounter(graph, tree).count();
}

}  // namespace whittle
