#include "linear/nested_dissection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "linear/minimum_degree.h"
#include "linear/vertex_cover.h"

namespace whittle {

namespace {

constexpr Index kLeaf = 500;    // parts up to this many nodes are not cut
constexpr Index kHalo = 240;    // of the settled neighbours of a leaf, those that its order heeds
constexpr Index kSample = 256;  // nodes of a part by which directions are compared and cuts are placed, at most
constexpr Index kStride = 8;    // of so many nodes at least, one
constexpr int kExact = 3;       // directions whose separators are found
constexpr std::array kShares = {0.4, 0.5, 0.6};  // of the nodes, below each of the cuts across a direction
constexpr int kCuts = kShares.size();
constexpr Index kSettled = -1;

// Axes and diagonals of a cube. Of equally good ones the first wins.
constexpr int kDirectionCount = 13;
constexpr double kDirections[kDirectionCount][3] = {
    {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, -1, 0}, {1, 0, 1}, {1, 0, -1},
    {0, 1, 1}, {0, 1, -1}, {1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {-1, 1, 1},
};

/// How far along a direction a node is; equal ones are told apart by their numbers, so every cut has nodes on both sides.
using Key = std::pair<double, Index>;

/// Whether a set holds a node at the place where it should be; places of nodes that are not in it may be anything.
bool isMember(const std::vector<Index>& set, Index place, Index node) {
  return place >= 0 && place < static_cast<Index>(set.size()) && set[place] == node;
}

/// The order is built in place: a part is a range of `nodes_`, cut into [low | high | separator].
class Dissection {
 public:
  Dissection(const Graph& graph, const Points& coordinates)
      : graph_(graph), coordinates_(coordinates), nodes_(graph.size()), part_(graph.size(), 0),
        zone_(graph.size(), 0), mark_(graph.size(), 0) {
    std::iota(nodes_.begin(), nodes_.end(), 0);
  }

  std::vector<Index> order();

 private:
  using Cuts = std::array<Key, kCuts>;
  struct Choice {
    Cuts cuts;
    int direction = 0;
    int cut = 0;
    Index separator = 0;
    double cost = std::numeric_limits<double>::infinity();
  };

  Key key(int direction, Index node) const;
  bool sameParts(Index v, Index w) const { return part_[v] == part_[w]; }
  Cuts placeCuts(int direction, Index first, Index last);
  double sampleCrossings(int direction, const Key& cut) const;
  void findZones(int direction, const Cuts& cuts, Index first, Index last);
  Index findSeparator(int cut);
  Choice bestCut(Index first, Index last);
  bool bisect(Index first, Index last);
  void orderLeaf(Index first, Index last);

  const Graph& graph_;
  const Points& coordinates_;
  std::vector<Index> nodes_;
  std::vector<Index> part_;  // of each node; kSettled: its place is final, it belongs to a separator or a leaf
  std::vector<std::uint8_t> zone_;  // how many of the cuts each node is above
  std::vector<Index> mark_;         // scratch, per node
  Index parts_ = 1;
  Index lowEnd_ = 0, highEnd_ = 0;  // of the last bisection, in `nodes_`

  std::vector<Key> sample_;
  std::vector<Index> border_;  // nodes with a neighbour in a higher zone
  VertexCover cover_;          // of the edges that a cut crosses, from low_ to high_
  std::vector<Index> low_, high_, start_, edges_;
};

std::vector<Index> Dissection::order() {
  std::vector<std::pair<Index, Index>> waiting = {{0, graph_.size()}};
  while (!waiting.empty()) {
    const auto [first, last] = waiting.back();
    waiting.pop_back();
    if (last - first > kLeaf && bisect(first, last)) {
      waiting.emplace_back(first, lowEnd_);
      waiting.emplace_back(lowEnd_, highEnd_);
    } else {
      orderLeaf(first, last);
    }
  }
  return nodes_;
}

Key Dissection::key(int direction, Index node) const {
  const double* d = kDirections[direction];
  const double along = coordinates_(node, 0) * d[0] + coordinates_(node, 1) * d[1] + coordinates_(node, 2) * d[2];
  return {std::isfinite(along) ? along : 0, node};
}

/// Cuts by the shares of a sample, which it leaves in `sample_`.
Dissection::Cuts Dissection::placeCuts(int direction, Index first, Index last) {
  const Index stride = std::max(kStride, (last - first) / kSample);
  sample_.clear();
  for (Index i = first; i < last; i += stride) sample_.push_back(key(direction, nodes_[i]));
  Cuts cuts;
  auto from = sample_.begin();
  for (int c = 0; c < kCuts; ++c) {
    const auto place = sample_.begin() + static_cast<Index>(kShares[c] * sample_.size());
    std::nth_element(from, place, sample_.end());
    cuts[c] = *place;
    from = place;
  }
  return cuts;
}

/// How many edges of the sample a cut would cross.
double Dissection::sampleCrossings(int direction, const Key& cut) const {
  double crossings = 0;
  for (const Key& own : sample_) {
    for (Index p = graph_.start[own.second]; p < graph_.start[own.second + 1]; ++p) {
      const Index other = graph_.neighbours[p];
      if (sameParts(own.second, other) && (own < cut) != (key(direction, other) < cut)) ++crossings;
    }
  }
  return crossings;
}

void Dissection::findZones(int direction, const Cuts& cuts, Index first, Index last) {
  for (Index i = first; i < last; ++i) {
    const Key own = key(direction, nodes_[i]);
    zone_[own.second] = 0;
    for (const Key& cut : cuts) zone_[own.second] += !(own < cut);
  }
  border_.clear();
  for (Index i = first; i < last; ++i) {
    const Index v = nodes_[i];
    const auto isHigher = [&](Index w) { return sameParts(v, w) && zone_[w] > zone_[v]; };
    const auto neighbours = graph_.neighbours.begin();
    if (std::any_of(neighbours + graph_.start[v], neighbours + graph_.start[v + 1], isHigher)) border_.push_back(v);
  }
}

/// The smallest separator between the zones below and above a cut is the smallest cover of the edges between them.
Index Dissection::findSeparator(int cut) {
  low_.clear(), high_.clear(), edges_.clear(), start_.assign(1, 0);
  for (const Index v : border_) {
    if (zone_[v] > cut) continue;
    for (Index p = graph_.start[v]; p < graph_.start[v + 1]; ++p) {
      const Index w = graph_.neighbours[p];
      if (!sameParts(v, w) || zone_[w] <= cut) continue;
      if (!isMember(high_, mark_[w], w)) {
        mark_[w] = static_cast<Index>(high_.size());
        high_.push_back(w);
      }
      edges_.push_back(mark_[w]);
    }
    if (static_cast<Index>(edges_.size()) == start_.back()) continue;
    low_.push_back(v);
    start_.push_back(static_cast<Index>(edges_.size()));
  }
  return cover_.find(start_, edges_, static_cast<Index>(high_.size()));
}

Dissection::Choice Dissection::bestCut(Index first, Index last) {
  std::array<Cuts, kDirectionCount> cuts;
  std::array<double, kDirectionCount> crossings;
  for (int d = 0; d < kDirectionCount; ++d) {
    cuts[d] = placeCuts(d, first, last);
    crossings[d] = sampleCrossings(d, cuts[d][kCuts / 2]);
  }
  Choice best;
  for (int tried = 0; tried < kExact; ++tried) {
    const int direction = static_cast<int>(std::min_element(crossings.begin(), crossings.end()) - crossings.begin());
    crossings[direction] = std::numeric_limits<double>::infinity();
    findZones(direction, cuts[direction], first, last);
    for (int cut = 0; cut < kCuts; ++cut) {
      const Index separator = findSeparator(cut);
      const double cost = separator / (kShares[cut] * (1 - kShares[cut]));
      if (cost < best.cost) best = {cuts[direction], direction, cut, separator, cost};
    }
  }
  return best;
}

/// Returns false for parts that no small separator cuts.
bool Dissection::bisect(Index first, Index last) {
  const Choice best = bestCut(first, last);
  if (3 * best.separator > last - first) return false;
  findZones(best.direction, best.cuts, first, last);
  findSeparator(best.cut);

  enum : Index { low, high, separator };
  for (Index i = first; i < last; ++i) mark_[nodes_[i]] = zone_[nodes_[i]] <= best.cut ? low : high;
  for (std::size_t i = 0; i < low_.size(); ++i) {
    if (cover_.leftCovered(static_cast<Index>(i))) mark_[low_[i]] = separator;
  }
  for (std::size_t i = 0; i < high_.size(); ++i) {
    if (cover_.rightCovered(static_cast<Index>(i))) mark_[high_[i]] = separator;
  }
  // Stable, so that memory is read in the order that the mesh came in.
  const auto begin = nodes_.begin() + first, end = nodes_.begin() + last;
  const auto highEnd = std::stable_partition(begin, end, [&](Index v) { return mark_[v] != separator; });
  const auto lowEnd = std::stable_partition(begin, highEnd, [&](Index v) { return mark_[v] == low; });
  std::for_each(begin, lowEnd, [&](Index v) { part_[v] = parts_; });
  std::for_each(highEnd, end, [&](Index v) { part_[v] = kSettled; });
  ++parts_;
  lowEnd_ = static_cast<Index>(lowEnd - nodes_.begin());
  highEnd_ = static_cast<Index>(highEnd - nodes_.begin());
  return true;
}

/// Orders a leaf by minimum degree as if the separators around it were one clique, which elimination makes of them: without
/// them its border would look sparse and go first.
void Dissection::orderLeaf(Index first, Index last) {
  const Index n = last - first;
  const Index haloLimit = n <= kLeaf ? kHalo : 0;
  std::vector<Index> halo;
  std::vector<std::pair<Index, Index>> edges;
  for (Index i = 0; i < n; ++i) mark_[nodes_[first + i]] = i;
  for (Index i = 0; i < n; ++i) {
    const Index v = nodes_[first + i];
    for (Index p = graph_.start[v]; p < graph_.start[v + 1]; ++p) {
      const Index w = graph_.neighbours[p];
      if (sameParts(v, w)) {
        if (mark_[w] < i) edges.emplace_back(mark_[w], i);
        continue;
      }
      if (!isMember(halo, mark_[w] - n, w)) {
        if (static_cast<Index>(halo.size()) == haloLimit) continue;
        mark_[w] = n + static_cast<Index>(halo.size());
        halo.push_back(w);
      }
      edges.emplace_back(i, mark_[w]);
    }
  }
  const Index all = n + static_cast<Index>(halo.size());
  for (Index a = n; a < all; ++a) {
    for (Index b = a + 1; b < all; ++b) edges.emplace_back(a, b);
  }
  const std::vector<Index> order = minimumDegreeOrder(graphOf(all, edges));
  const std::vector<Index> leaf(nodes_.begin() + first, nodes_.begin() + last);
  auto next = nodes_.begin() + first;
  for (const Index i : order) {
    if (i < n) *next++ = leaf[i];
  }
  for (const Index v : leaf) part_[v] = kSettled;
}

}  // namespace

std::vector<Index> nestedDissectionOrder(const Graph& graph, const Points& coordinates) {
  return Dissection(graph, coordinates).order();
}

}  // namespace whittle
