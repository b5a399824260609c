#pragma once

#include <vector>

#include "constraints/planes.h"
#include "mesh/adjacency.h"
#include "simd/lanes.h"

namespace whittle {

/// Holds every part that no handle holds: the energy does not see where such a part lies, so each is solved with one of
/// its vertices pinned and then moved back to where its area centroid was. One pin for all parts would leave the system
/// singular, and would throw the parts together. A part on planes is loose along those directions only that lie in all
/// of them: along these it is pinned and keeps its centroid, and across them the planes say where it is.
class Gauge {
 public:
  /// @param areas #V barycentric areas of the rest shape, the centroid's weights
  /// @param planes that vertices are held on
  Gauge(const Components& components, const std::vector<Index>& handles, const Points& rest, const Scalars& areas,
        const Planes& planes = {});

  /// One vertex of each part that neither a handle nor a plane holds.
  const std::vector<Index>& pins() const { return pins_; }
  /// What holds one vertex of each part on planes along the directions in which it is loose.
  const std::vector<RowPlane>& pinPlanes() const { return pinPlanes_; }

  /// Moves each loose part so that its centroid lies where it lay at rest, as far as its planes let it. Allocates
  /// nothing.
  void restoreCentroids(Points& positions);

  /// Finds how far each loose part has to move, besides these moves of displaced vertices, for its centroid to lie where
  /// it lay at rest, as far as its planes let it. Allocates nothing.
  void balance(const LaneRows& displacements, const LaneRows& moves);
  /// Translation of vertex v's component as `balance` found it; zero where the component is held.
  Lanes shift(std::size_t v) const { return load(&laneShifts_[loosePart_[v] + 1]); }

 private:
  /// A loose part that is on planes.
  struct Slide {
    Index part;
    Mat3 along;  // what a move has along them
  };

  void weighCentroids(const Points& rest, const Scalars& areas);
  void sumCentroids(const Points& positions, Points& centroids) const;
  void keepOnPlanes(Points& shifts) const;

  std::vector<Index> loosePart_;  // #V, index of the loose part, or −1; filled up to whole batches
  std::vector<Index> pins_;
  std::vector<RowPlane> pinPlanes_;
  std::vector<Slide> slides_;
  Scalars weights_;       // #V, sums to 1 in each loose part
  Points restCentroids_;  // #loose parts×3
  Points shifts_;
  std::vector<LaneRow> laneShifts_;  // the same in single precision, after one of zero
};

}  // namespace whittle
