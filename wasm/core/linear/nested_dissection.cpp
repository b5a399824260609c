#include "linear/nested_dissection.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "linear/minimum_degree.h"

namespace whittle {

namespace {

constexpr Index kLeaf = 500;  // parts up to this many nodes are not cut
constexpr Index kHalo = 240;  // of the settled neighbours of a leaf, those that its order heeds
constexpr Index kSettled = -1;

// What a node costs, in the units of `slices.h`: in each cut of its part, and in its leaf.
constexpr double kCutWork = 600;
constexpr double kLeafWork = 4000;

/// The work that a part of so many nodes makes, if all is cut in halves.
double expectedWork(Index nodes) {
  const double levels = nodes > kLeaf ? std::log2(static_cast<double>(nodes) / kLeaf) : 0;
  return nodes * (kLeafWork + kCutWork * levels);
}

}  // namespace

struct NestedDissection::Leaf {
  Range range;
  Graph graph;
  MinimumDegree degrees;

  Leaf(Range range, Graph own) : range(range), graph(std::move(own)), degrees(graph) {}
};

NestedDissection::NestedDissection(const Graph& graph, const Points& coordinates)
    : graph_(graph), nodes_(graph.size()), part_(graph.size(), 0),
      bisector_(graph, coordinates, part_), waiting_{{0, graph.size()}}, place_(graph.size(), 0),
      workLeft_(expectedWork(graph.size())), allWork_(workLeft_) {
  std::iota(nodes_.begin(), nodes_.end(), 0);
}

NestedDissection::~NestedDissection() = default;

double NestedDissection::next(double work) {
  while (work > 0 && (leaf_ || !waiting_.empty())) {
    if (!leaf_) {
      const Range range = waiting_.back();
      waiting_.pop_back();
      workLeft_ -= expectedWork(range.count());
      work -= kCutWork * range.count();
      if (range.count() > kLeaf && bisect(range)) continue;
      beginLeaf(range);
    }
    if (leaf_->degrees.next(work) < 1) break;
    work -= kLeafWork * leaf_->range.count();
    finishLeaf();
  }
  return leaf_ || !waiting_.empty() ? std::min(0.999, 1 - workLeft_ / allWork_) : 1;
}

std::vector<Index> NestedDissection::take() { return std::move(nodes_); }

/// Returns false for parts that no small separator cuts.
bool NestedDissection::bisect(Range range) {
  if (!bisector_.cut(nodes_.data() + range.first, range.count())) return false;
  // Stable, so that memory is read in the order that the mesh came in.
  const auto begin = nodes_.begin() + range.first, end = nodes_.begin() + range.last;
  const auto side = [&](Index v) { return bisector_.side(v); };
  const auto separator = std::stable_partition(begin, end, [&](Index v) { return side(v) != Bisector::separator; });
  const auto high = std::stable_partition(begin, separator, [&](Index v) { return side(v) == Bisector::low; });
  std::for_each(begin, high, [&](Index v) { part_[v] = parts_; });
  std::for_each(separator, end, [&](Index v) { part_[v] = kSettled; });
  ++parts_;
  const Index lowEnd = static_cast<Index>(high - nodes_.begin()),
              highEnd = static_cast<Index>(separator - nodes_.begin());
  for (const Range half : {Range{range.first, lowEnd}, Range{lowEnd, highEnd}}) {
    waiting_.push_back(half);
    workLeft_ += expectedWork(half.count());
  }
  return true;
}

/// Has a leaf ordered as if the separators around it were one clique, which elimination makes of them: without them its
/// border would look sparse and go first.
void NestedDissection::beginLeaf(Range range) { leaf_ = std::make_unique<Leaf>(range, leafGraph(range)); }

/// The nodes of a leaf, then those of its halo.
Graph NestedDissection::leafGraph(Range range) {
  const Index n = range.count();
  const Index haloLimit = n <= kLeaf ? kHalo : 0;
  std::vector<Index> halo;
  std::vector<std::pair<Index, Index>> edges;
  for (Index i = 0; i < n; ++i) place_[nodes_[range.first + i]] = i;
  for (Index i = 0; i < n; ++i) {
    const Index v = nodes_[range.first + i];
    for (Index p = graph_.start[v]; p < graph_.start[v + 1]; ++p) {
      const Index w = graph_.neighbours[p];
      if (part_[v] == part_[w]) {
        if (place_[w] < i) edges.emplace_back(place_[w], i);
        continue;
      }
      if (!isMember(halo, place_[w] - n, w)) {
        if (static_cast<Index>(halo.size()) == haloLimit) continue;
        place_[w] = n + static_cast<Index>(halo.size());
        halo.push_back(w);
      }
      edges.emplace_back(i, place_[w]);
    }
  }
  const Index all = n + static_cast<Index>(halo.size());
  for (Index a = n; a < all; ++a) {
    for (Index b = a + 1; b < all; ++b) edges.emplace_back(a, b);
  }
  return graphOf(all, edges);
}

void NestedDissection::finishLeaf() {
  const Range range = leaf_->range;
  const std::vector<Index> own(nodes_.begin() + range.first, nodes_.begin() + range.last);
  auto next = nodes_.begin() + range.first;
  for (const Index i : leaf_->degrees.take()) {
    if (i < range.count()) *next++ = own[i];
  }
  for (const Index v : own) part_[v] = kSettled;
  leaf_.reset();
}

}  // namespace whittle
