#pragma once

#include <vector>

#include "mesh/adjacency.h"
#include "simd/lanes.h"

namespace whittle {

/// Holds every part that no handle holds: the energy does not see where such a part lies, so each is solved with one of
/// its vertices pinned and then moved back to where its area centroid was. One pin for all parts would leave the system
/// singular, and would throw the parts together.
class Gauge {
 public:
  /// @param areas #V barycentric areas of the rest shape, the centroid's weights
  Gauge(const Components& components, const std::vector<Index>& handles, const Points& rest, const Scalars& areas);

  /// One vertex of each part without a handle.
  const std::vector<Index>& pins() const { return pins_; }

  /// Moves each part without a handle so that its centroid lies where it lay at rest. Allocates nothing.
  void restoreCentroids(Points& positions);

  /// Finds how far each part without a handle has to move, besides these moves of displaced vertices, for its centroid
  /// to lie where it lay at rest. Allocates nothing.
  void balance(const LaneRows& displacements, const LaneRows& moves);
  /// Translation of vertex v's component as `balance` found it; zero where the component has a handle.
  Lanes shift(std::size_t v) const { return load(&laneShifts_[floatingPart_[v] + 1]); }

 private:
  void sumCentroids(const Points& positions, Points& centroids) const;

  std::vector<Index> floatingPart_;  // #V, index of the part without handle, or −1; filled up to whole batches
  std::vector<Index> pins_;          // #parts without handle
  Scalars weights_;                  // #V, sums to 1 in each part
  Points restCentroids_;             // #parts without handle ×3
  Points shifts_;
  std::vector<LaneRow> laneShifts_;  // the same in single precision, after one of zero
};

}  // namespace whittle
