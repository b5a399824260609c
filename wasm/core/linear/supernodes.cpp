#include "linear/supernodes.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/tiering.h"

namespace whittle {

namespace {

/// Zeros that a panel may store, by its number of columns (the thresholds of CHOLMOD: Chen et al. 2008, §5).
bool isWorthMerging(Index columns, double shareOfZeros) {
  if (columns <= 4) return true;
  if (columns <= 16) return shareOfZeros < 0.8;
  if (columns <= 48) return shareOfZeros < 0.1;
  return shareOfZeros < 0.05;
}

struct Panel {
  Index start;
  Index columns;
  Index height;
};

/// Share of zeros in a panel of nodes that holds `entries` blocks of L, in unknowns: blocks on the diagonal hold a
/// triangle.
double shareOfZeros(const Panel& panel, std::int64_t entries, double blockSize) {
  const double k = blockSize * panel.columns, height = blockSize * panel.height;
  const double stored = k * (k + 1) / 2 + k * (height - k);
  const double needed = blockSize * blockSize * static_cast<double>(entries) - k * (blockSize - 1) / 2;
  return 1 - needed / stored;
}

/// Runs of columns that share their rows, then merged with what comes right before them in the tree where that pays.
/// @param n columns that are eliminated
std::vector<Panel> findPanels(Index n, const std::vector<Index>& parent, const std::vector<Index>& counts,
                              Index blockSize) {
  std::vector<std::int64_t> entriesBefore(n + 1, 0);
  for (Index j = 0; j < n; ++j) entriesBefore[j + 1] = entriesBefore[j] + counts[j];

  std::vector<Panel> panels;
  for (Index first = 0; first < n;) {
    Index last = first;
    while (last + 1 < n && parent[last] == last + 1 && counts[last] == counts[last + 1] + 1) ++last;
    panels.push_back({first, last - first + 1, counts[first]});
    first = last + 1;

    while (panels.size() > 1) {
      const Panel& below = panels[panels.size() - 2];
      const Panel& above = panels.back();
      const Index up = parent[below.start + below.columns - 1];
      if (up < above.start || up >= above.start + above.columns) break;  // a root, or a sibling
      const Panel merged{below.start, below.columns + above.columns, below.columns + above.height};
      const std::int64_t entries = entriesBefore[merged.start + merged.columns] - entriesBefore[merged.start];
      if (!isWorthMerging(blockSize * merged.columns, shareOfZeros(merged, entries, blockSize))) break;
      panels.pop_back();
      panels.back() = merged;
    }
  }
  return panels;
}

/// Adds a row to the panels that it reaches: the supernodes of its entries in A and what lies above them in the tree,
/// up to its own.
/// @param mark the last row that reached each supernode
/// @param next where the next row of each goes
WHITTLE_OWN_FUNCTION void addRow(const Graph& graph, const EliminationTree& tree, Index row, const Index* supernodeOf,
                                 Index* mark, std::size_t* next, Supernodes& result) {
  const Index node = tree.order[row];
  if (supernodeOf[row] >= 0) mark[supernodeOf[row]] = row;
  for (Index p = graph.start[node]; p < graph.start[node + 1]; ++p) {
    const Index column = tree.positionOf[graph.neighbours[p]];
    if (column > row) continue;
    for (Index s = supernodeOf[column]; s >= 0 && mark[s] != row; s = result.parent[s]) {
      mark[s] = row;
      result.rows[next[s]++] = row;
    }
  }
}

/// The rows of every panel, its own columns first. Rows come one after the other, so they are sorted.
void fillRows(const Graph& graph, const EliminationTree& tree, const std::vector<Panel>& panels, Supernodes& result) {
  const Index count = static_cast<Index>(panels.size());
  std::vector<Index> supernodeOf(tree.size(), -1), mark(count, -1);  // −1: of columns that are not eliminated
  result.columnStart.assign(1, 0);
  result.rowStart.assign(1, 0);
  for (Index s = 0; s < count; ++s) {
    std::fill_n(supernodeOf.begin() + panels[s].start, panels[s].columns, s);
    result.columnStart.push_back(result.columnStart[s] + panels[s].columns);
    result.rowStart.push_back(result.rowStart[s] + panels[s].height);
  }
  std::vector<std::size_t> next(count);
  result.rows.resize(result.rowStart[count]);
  for (Index s = 0; s < count; ++s) {
    next[s] = result.rowStart[s] + panels[s].columns;
    std::iota(result.rows.begin() + result.rowStart[s], result.rows.begin() + next[s], panels[s].start);
    const Index parent = tree.parent[result.columnStart[s + 1] - 1];
    result.parent.push_back(parent < 0 ? -1 : supernodeOf[parent]);
  }
  for (Index row = 0; row < tree.size(); ++row)
    addRow(graph, tree, row, supernodeOf.data(), mark.data(), next.data(), result);
}

std::vector<Index> asNumbered(Index nodes) {
  std::vector<Index> order(nodes);
  std::iota(order.begin(), order.end(), 0);
  return order;
}

/// From nodes to unknowns: every column and row becomes `blockSize` of them.
Supernodes expand(const Supernodes& ofNodes, Index blockSize) {
  Supernodes result;
  result.parent = ofNodes.parent;
  const auto repeat = [&](const std::vector<Index>& nodes, std::vector<Index>& unknowns) {
    unknowns.reserve(nodes.size() * blockSize);
    for (const Index node : nodes) {
      for (Index component = 0; component < blockSize; ++component) unknowns.push_back(blockSize * node + component);
    }
  };
  repeat(ofNodes.newOf, result.newOf);
  repeat(ofNodes.rows, result.rows);
  for (const Index start : ofNodes.columnStart) result.columnStart.push_back(blockSize * start);
  for (const std::size_t start : ofNodes.rowStart) result.rowStart.push_back(blockSize * start);
  return result;
}

}  // namespace

double SupernodeAnalysis::next(double work) {
  // Each but the ordering is one pass over the graph: pieces of some 10 ms for 160 000 nodes.
  enum Stage { graph, order, tree, supernodes, done };
  constexpr double kShares[] = {0, 0.1, 0.7, 0.8, 1};  // that are done when a stage begins
  double ordered = 0;
  switch (stage_) {
    case graph:
      graph_ = graphOf(A_, settings_.blockSize);
      if (!settings_.isOrdered) ordering_.emplace(graph_, settings_.coordinates, settings_.blockSize);
      stage_ = settings_.isOrdered ? tree : order;
      break;
    case order:
      ordered = ordering_->next(work);
      if (ordered == 1) stage_ = tree;
      break;
    case tree:
      tree_ = eliminationTree(graph_, this->order(), settings_.kept);
      stage_ = supernodes;
      break;
    case supernodes: findSupernodes(), stage_ = done; break;
  }
  return kShares[stage_] + (stage_ == order ? ordered * (kShares[tree] - kShares[order]) : 0);
}

/// The order that was found or given, kept nodes last.
std::vector<Index> SupernodeAnalysis::order() {
  if (!ordering_) return asNumbered(graph_.size());
  std::vector<Index> order = ordering_->take();
  ordering_.reset();
  if (settings_.kept == 0) return order;
  const Index eliminated = graph_.size() - settings_.kept;
  const auto kept = std::stable_partition(order.begin(), order.end(), [&](Index node) { return node < eliminated; });
  std::sort(kept, order.end());
  return order;
}

void SupernodeAnalysis::findSupernodes() {
  const Index eliminated = graph_.size() - settings_.kept;
  const std::vector<Index> counts = columnCounts(graph_, tree_);
  fillRows(graph_, tree_, findPanels(eliminated, tree_.parent, counts, settings_.blockSize), result_);
  result_.newOf = std::move(tree_.positionOf);
  if (settings_.blockSize > 1) result_ = expand(result_, settings_.blockSize);
}

}  // namespace whittle
