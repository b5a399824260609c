#pragma once

#include <vector>

#include "geometry/feature_edges.h"

namespace whittle {

/// Faces that hang together and bend by less than 1° from one to the next: sides of a box, facets, and all of a round
/// part that is meshed very finely.
struct FlatRegions {
  std::vector<Index> of;                  // #F, the region of a face
  std::vector<std::vector<Index>> faces;  // of each region, ascending

  FlatRegions(Index faceCount, const std::vector<FacePair>& pairs);
};

}  // namespace whittle
