#pragma once

#include <array>
#include <utility>
#include <vector>

#include "linear/graph.h"
#include "linear/vertex_cover.h"

namespace whittle {

/// Whether a set holds a node at the place where it should be; places of nodes that are not in it may be anything.
inline bool isMember(const std::vector<Index>& set, Index place, Index node) {
  return place >= 0 && place < static_cast<Index>(set.size()) && set[place] == node;
}

/// Cuts parts of a graph in two, across the best of several directions in space. Its memory is claimed once for all
/// parts.
class Bisector {
 public:
  enum Side : std::uint8_t { low, high, separator };

  /// @param coordinates #nodes×3; only suggest where to cut
  /// @param part of each node; edges between nodes of different parts do not count. Both are kept by the caller.
  Bisector(const Graph& graph, const Points& coordinates, const std::vector<Index>& part)
      : graph_(graph), coordinates_(coordinates), part_(part), zone_(graph.size(), 0), mark_(graph.size(), 0) {}

  /// Finds a small set of nodes that separates the part that some nodes are; returns false if there is none.
  bool cut(const Index* nodes, Index count);
  /// The side of a node of the part that was cut last.
  Side side(Index node) const { return static_cast<Side>(zone_[node]); }

 private:
  static constexpr int kCuts = 3;  // across each direction that is looked at closely
  static constexpr int kDirections = 13;
  /// How far along a direction a node is; equal ones are told apart by their numbers, so every cut has nodes on both
  /// sides.
  using Key = std::pair<double, Index>;
  using Cuts = std::array<Key, kCuts>;
  struct Choice;

  static const double kShares[kCuts];  // of the nodes, below each of the cuts
  static const double kDirection[kDirections][3];

  Key key(int direction, Index node) const;
  bool sameParts(Index v, Index w) const { return part_[v] == part_[w]; }
  Cuts placeCuts(int direction, const Index* nodes, Index count);
  double sampleCrossings(int direction, const Key& cut) const;
  void findZones(int direction, const Cuts& cuts, const Index* nodes, Index count);
  Index findSeparator(int cut);
  Choice bestCut(const Index* nodes, Index count);

  const Graph& graph_;
  const Points& coordinates_;
  const std::vector<Index>& part_;
  std::vector<std::uint8_t> zone_;  // how many of the cuts each node is above; in the end its side
  std::vector<Index> mark_;         // place of a node in `high_`
  std::vector<Key> sample_;
  std::vector<Index> border_;  // nodes with a neighbour in a higher zone
  VertexCover cover_;          // of the edges that a cut crosses, from low_ to high_
  std::vector<Index> low_, high_, start_, edges_;
};

}  // namespace whittle
