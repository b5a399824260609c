#pragma once

#include <vector>

#include "base/types.h"

namespace whittle {

/// Smooths where triangles have become bad (2021, §5.1): their vertices move some way to the mean of their ring. What
/// was bad from the beginning may stay so, and the rim of an open mesh keeps its place.
class RingSmoothing {
 public:
  /// @param rest whose triangles are the measure
  void prepare(const Points& rest, const Triangles& triangles);

  /// Moves the corners of bad triangles by `share` of their way. Allocates nothing.
  void smooth(double share, const Triangles& triangles, Points& positions);

 private:
  Scalars acceptable_;             // #F, the quality below which a triangle is bad
  std::vector<Index> neighbours_;  // #V, how many the ring sums hold; 0 on the rim
  std::vector<bool> isBad_;        // #V
  Points sums_;                    // #V×3
};

}  // namespace whittle
