#pragma once

#include "geometry/smooth_fans.h"

namespace whittle {

/// Where the normals of vertices stand that are taken four at a time: one slot, a normal of each of the four, after the
/// other. A batch has as many as the one of its vertices that has the most smooth fans; on a smooth surface one.
struct FanLayout {
  std::vector<Index> start = {0};  // #batches + 1: the slots of batch b are start[b] … start[b + 1] − 1
  std::vector<Index> lanes;        // #fans: the lane of a fan, counted through all slots; slot lane / 4, its lane % 4
  Index most = 1;                  // slots of one batch

  FanLayout() = default;
  explicit FanLayout(const SmoothFans& fans);
  /// Of so many elements that have one normal each.
  static FanLayout ofSingles(Index count);

  std::size_t batchCount() const { return start.size() - 1; }
  std::size_t slotCount() const { return static_cast<std::size_t>(start.back()); }
};

}  // namespace whittle
