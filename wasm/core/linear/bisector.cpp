#include "linear/bisector.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace whittle {

namespace {

constexpr Index kSample = 256;  // nodes of a part by which directions are compared and cuts are placed, at most
constexpr Index kStride = 8;    // of so many nodes at least, one
constexpr int kExact = 3;       // directions whose separators are found
constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

const double Bisector::kShares[kCuts] = {0.4, 0.5, 0.6};

// Axes and diagonals of a cube. Of equally good ones the first wins.
const double Bisector::kDirection[kDirections][3] = {
    {1, 0, 0}, {0, 1, 0},  {0, 0, 1}, {1, 1, 0},  {1, -1, 0}, {1, 0, 1},  {1, 0, -1},
    {0, 1, 1}, {0, 1, -1}, {1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {-1, 1, 1},
};

struct Bisector::Choice {
  Cuts cuts;
  int direction = 0;
  int cut = 0;
  Index separator = 0;
  double cost = kInfinity;
};

bool Bisector::cut(const Index* nodes, Index count) {
  const Choice best = bestCut(nodes, count);
  if (3 * best.separator > count) return false;
  findZones(best.direction, best.cuts, nodes, count);
  findSeparator(best.cut);
  for (Index i = 0; i < count; ++i) zone_[nodes[i]] = zone_[nodes[i]] <= best.cut ? low : high;
  for (std::size_t i = 0; i < low_.size(); ++i) {
    if (cover_.leftCovered(static_cast<Index>(i))) zone_[low_[i]] = separator;
  }
  for (std::size_t i = 0; i < high_.size(); ++i) {
    if (cover_.rightCovered(static_cast<Index>(i))) zone_[high_[i]] = separator;
  }
  return true;
}

Bisector::Key Bisector::key(int direction, Index node) const {
  const double* d = kDirection[direction];
  const double along = coordinates_(node, 0) * d[0] + coordinates_(node, 1) * d[1] + coordinates_(node, 2) * d[2];
  return {std::isfinite(along) ? along : 0, node};
}

/// Cuts by the shares of a sample, which it leaves in `sample_`.
Bisector::Cuts Bisector::placeCuts(int direction, const Index* nodes, Index count) {
  const Index stride = std::max(kStride, count / kSample);
  sample_.clear();
  for (Index i = 0; i < count; i += stride) sample_.push_back(key(direction, nodes[i]));
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
double Bisector::sampleCrossings(int direction, const Key& cut) const {
  double crossings = 0;
  for (const Key& own : sample_) {
    for (Index p = graph_.start[own.second]; p < graph_.start[own.second + 1]; ++p) {
      const Index other = graph_.neighbours[p];
      if (sameParts(own.second, other) && (own < cut) != (key(direction, other) < cut)) ++crossings;
    }
  }
  return crossings;
}

void Bisector::findZones(int direction, const Cuts& cuts, const Index* nodes, Index count) {
  for (Index i = 0; i < count; ++i) {
    const Key own = key(direction, nodes[i]);
    zone_[own.second] = 0;
    for (const Key& cut : cuts) zone_[own.second] += !(own < cut);
  }
  border_.clear();
  for (Index i = 0; i < count; ++i) {
    const Index v = nodes[i];
    const auto isHigher = [&](Index w) { return sameParts(v, w) && zone_[w] > zone_[v]; };
    const auto neighbours = graph_.neighbours.begin();
    if (std::any_of(neighbours + graph_.start[v], neighbours + graph_.start[v + 1], isHigher)) border_.push_back(v);
  }
}

/// The smallest separator between the zones below and above a cut is the smallest cover of the edges between them.
Index Bisector::findSeparator(int cut) {
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

Bisector::Choice Bisector::bestCut(const Index* nodes, Index count) {
  std::array<Cuts, kDirections> cuts;
  std::array<double, kDirections> crossings;
  for (int d = 0; d < kDirections; ++d) {
    cuts[d] = placeCuts(d, nodes, count);
    crossings[d] = sampleCrossings(d, cuts[d][kCuts / 2]);
  }
  Choice best;
  for (int tried = 0; tried < kExact; ++tried) {
    const int direction = static_cast<int>(std::min_element(crossings.begin(), crossings.end()) - crossings.begin());
    crossings[direction] = kInfinity;
    findZones(direction, cuts[direction], nodes, count);
    for (int cut = 0; cut < kCuts; ++cut) {
      const Index separator = findSeparator(cut);
      const double cost = separator / (kShares[cut] * (1 - kShares[cut]));
      if (cost < best.cost) best = {cuts[direction], direction, cut, separator, cost};
    }
  }
  return best;
}

}  // namespace whittle
