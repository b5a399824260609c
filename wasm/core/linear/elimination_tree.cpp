#include "linear/elimination_tree.h"

#include <algorithm>
#include <numeric>

namespace whittle {

namespace {

constexpr Index kNone = -1;

}  // namespace

UpperPattern upperPattern(const Graph& graph, const std::vector<Index>& newOf) {
  UpperPattern pattern;
  pattern.start.assign(graph.size() + 1, 0);
  const auto forEachEntry = [&](auto&& visit) {
    for (Index node = 0; node < graph.size(); ++node) {
      for (Index p = graph.start[node]; p < graph.start[node + 1]; ++p) {
        const Index row = newOf[graph.neighbours[p]], column = newOf[node];
        if (row < column) visit(row, column);
      }
    }
  };
  forEachEntry([&](Index, Index column) { ++pattern.start[column + 1]; });
  std::partial_sum(pattern.start.begin(), pattern.start.end(), pattern.start.begin());
  pattern.rows.resize(pattern.start.back());
  std::vector<Index> next(pattern.start.begin(), pattern.start.end() - 1);
  forEachEntry([&](Index row, Index column) { pattern.rows[next[column]++] = row; });
  return pattern;
}

std::vector<Index> eliminationTree(const UpperPattern& pattern) {
  const Index n = pattern.size();
  std::vector<Index> parent(n, kNone);
  std::vector<Index> ancestor(n, kNone);  // shortcuts towards the root of what is built so far
  for (Index column = 0; column < n; ++column) {
    for (Index p = pattern.start[column]; p < pattern.start[column + 1]; ++p) {
      Index v = pattern.rows[p];
      while (v != kNone && v != column) {
        const Index next = ancestor[v];
        ancestor[v] = column;
        if (next == kNone) parent[v] = column;
        v = next;
      }
    }
  }
  return parent;
}

std::vector<Index> postorder(const std::vector<Index>& parent) {
  const Index n = static_cast<Index>(parent.size());
  std::vector<Index> firstChild(n, kNone), sibling(n, kNone);
  std::vector<Index> roots;
  for (Index v = n - 1; v >= 0; --v) {
    if (parent[v] == kNone) {
      roots.push_back(v);
    } else {
      sibling[v] = firstChild[parent[v]];
      firstChild[parent[v]] = v;
    }
  }
  std::reverse(roots.begin(), roots.end());

  std::vector<Index> order;
  order.reserve(n);
  std::vector<Index> path;
  for (const Index root : roots) {
    path.push_back(root);
    while (!path.empty()) {
      const Index v = path.back();
      if (firstChild[v] == kNone) {
        order.push_back(v);
        path.pop_back();
      } else {
        path.push_back(firstChild[v]);
        firstChild[v] = sibling[firstChild[v]];  // not to be visited again
      }
    }
  }
  return order;
}

std::vector<Index> columnCounts(const UpperPattern& pattern, const std::vector<Index>& parent) {
  const Index n = pattern.size();
  std::vector<Index> counts(n, 1);
  std::vector<Index> seenInRow(n, kNone);
  for (Index row = 0; row < n; ++row) {
    // Row `row` of L is the subtree that its entries of A span below it.
    seenInRow[row] = row;
    for (Index p = pattern.start[row]; p < pattern.start[row + 1]; ++p) {
      for (Index v = pattern.rows[p]; seenInRow[v] != row; v = parent[v]) {
        seenInRow[v] = row;
        ++counts[v];
      }
    }
  }
  return counts;
}

}  // namespace whittle
