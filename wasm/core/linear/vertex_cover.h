#pragma once

#include <vector>

#include "base/types.h"

namespace whittle {

/// A smallest set of nodes that touches every edge of a bipartite graph, from a largest matching by Kőnig's theorem.
/// Kept between calls so that its memory is claimed once.
class VertexCover {
 public:
  /// @param start #left + 1: into `neighbours`
  /// @param neighbours right nodes of each left node, in [0, rightCount)
  /// @returns the size of the cover
  Index find(const std::vector<Index>& start, const std::vector<Index>& neighbours, Index rightCount);

  bool leftCovered(Index left) const { return depth_[left] < 0; }
  bool rightCovered(Index right) const { return reached_[right]; }

 private:
  bool layer();
  bool augment(Index root);

  const Index* start_ = nullptr;
  const Index* neighbours_ = nullptr;
  std::vector<Index> mateOfLeft_, mateOfRight_;  // −1: unmatched
  std::vector<Index> depth_;                     // of left nodes along alternating paths, −1: not reached
  std::vector<char> reached_;                    // right nodes on alternating paths
  std::vector<Index> queue_, next_;
};

}  // namespace whittle
