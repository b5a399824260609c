#include "linear/supernodes.h"

#include <algorithm>
#include <numeric>

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

/// Share of zeros in a panel of nodes that holds `entries` blocks of L, in unknowns: blocks on the diagonal hold a triangle.
double shareOfZeros(const Panel& panel, std::int64_t entries, double blockSize) {
  const double k = blockSize * panel.columns, height = blockSize * panel.height;
  const double stored = k * (k + 1) / 2 + k * (height - k);
  const double needed = blockSize * blockSize * static_cast<double>(entries) - k * (blockSize - 1) / 2;
  return 1 - needed / stored;
}

/// Runs of columns that share their rows, then merged with what comes right before them in the tree where that pays.
std::vector<Panel> findPanels(const std::vector<Index>& parent, const std::vector<Index>& counts, Index blockSize) {
  const Index n = static_cast<Index>(parent.size());
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

/// The rows of every panel: its own columns, A's entries below them and what its children hand up.
void fillRows(const UpperPattern& pattern, const std::vector<Panel>& panels, Supernodes& result) {
  const Index n = pattern.size();
  std::vector<Index> supernodeOf(n);
  for (Index s = 0; s < result.count(); ++s) {
    std::fill_n(supernodeOf.begin() + panels[s].start, panels[s].columns, s);
  }
  // A's lower pattern by column: the transpose of the upper one.
  std::vector<Index> start(n + 1, 0), below(pattern.rows.size());
  for (const Index row : pattern.rows) ++start[row + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<Index> next(start.begin(), start.end() - 1);
  for (Index column = 0; column < n; ++column) {
    for (Index p = pattern.start[column]; p < pattern.start[column + 1]; ++p) below[next[pattern.rows[p]]++] = column;
  }

  std::vector<Index> mark(n, -1), firstChild(panels.size(), -1), sibling(panels.size(), -1);
  for (Index s = 0; s < result.count(); ++s) {
    const Index first = panels[s].start, end = first + panels[s].columns;
    for (Index j = first; j < end; ++j) result.rows.push_back(j);
    const auto add = [&](Index row) {
      if (row < end || mark[row] == s) return;
      mark[row] = s;
      result.rows.push_back(row);
    };
    for (Index p = start[first]; p < start[end]; ++p) add(below[p]);
    for (Index child = firstChild[s]; child >= 0; child = sibling[child]) {
      for (std::size_t p = result.rowStart[child]; p < result.rowStart[child + 1]; ++p) add(result.rows[p]);
    }
    std::sort(result.rows.begin() + result.rowStart[s] + panels[s].columns, result.rows.end());
    result.rowStart.push_back(result.rows.size());
    if (result.height(s) == panels[s].columns) continue;
    const Index parent = supernodeOf[result.rowsOf(s)[panels[s].columns]];
    result.parent[s] = parent;
    sibling[s] = firstChild[parent];
    firstChild[parent] = s;
  }
}

std::vector<Index> positions(const std::vector<Index>& order) {
  std::vector<Index> positionOf(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) positionOf[order[i]] = static_cast<Index>(i);
  return positionOf;
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

Supernodes analyzeSupernodes(const SparseMatrix& A, const Ordering& ordering) {
  const Graph graph = graphOf(A, ordering.blockSize);
  Supernodes result;
  result.newOf = positions(ordering.isOrdered ? postordered(graph, asNumbered(graph.size()))
                                              : eliminationOrder(graph, ordering.coordinates, ordering.blockSize));
  const UpperPattern pattern = upperPattern(graph, result.newOf);
  const std::vector<Index> parent = eliminationTree(pattern);
  const std::vector<Panel> panels = findPanels(parent, columnCounts(pattern, parent), ordering.blockSize);

  for (const Panel& panel : panels) result.columnStart.push_back(panel.start);
  result.columnStart.push_back(pattern.size());
  result.parent.assign(panels.size(), -1);
  result.rowStart.push_back(0);
  fillRows(pattern, panels, result);
  return ordering.blockSize == 1 ? result : expand(result, ordering.blockSize);
}

}  // namespace whittle
