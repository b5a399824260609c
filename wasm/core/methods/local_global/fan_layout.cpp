#include "methods/local_global/fan_layout.h"

#include <algorithm>
#include <numeric>

#include "simd/lanes.h"

namespace whittle {

FanLayout::FanLayout(const SmoothFans& fans) : lanes(static_cast<std::size_t>(fans.count())) {
  const Index vertexCount = static_cast<Index>(fans.start.size()) - 1;
  for (Index first = 0; first < vertexCount; first += 4) {
    Index slots = 1;
    for (Index v = first; v < std::min(first + 4, vertexCount); ++v) {
      slots = std::max(slots, fans.countAt(v));
      for (Index k = 0; k < fans.countAt(v); ++k) lanes[fans.start[v] + k] = 4 * (start.back() + k) + v % 4;
    }
    start.push_back(start.back() + slots);
    most = std::max(most, slots);
  }
}

FanLayout FanLayout::ofSingles(Index count) {
  FanLayout layout;
  layout.start.resize(whittle::batchCount(count) + 1);
  layout.lanes.resize(static_cast<std::size_t>(count));
  std::iota(layout.start.begin(), layout.start.end(), 0);
  std::iota(layout.lanes.begin(), layout.lanes.end(), 0);
  return layout;
}

}  // namespace whittle
