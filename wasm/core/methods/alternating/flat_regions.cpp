#include "methods/alternating/flat_regions.h"

#include "mesh/disjoint_sets.h"

namespace whittle {

namespace {

constexpr double kFlat = EIGEN_PI / 180;

}  // namespace

FlatRegions::FlatRegions(Index faceCount, const std::vector<FacePair>& pairs) : of(faceCount) {
  DisjointSets sets(faceCount);
  for (const FacePair& pair : pairs) {
    if (pair.angle < kFlat) sets.join(faceOf(pair.first), faceOf(pair.second));
  }
  for (Index f = 0; f < faceCount; ++f) {
    const Index first = sets.find(f);
    if (first == f) faces.emplace_back();
    of[f] = first == f ? static_cast<Index>(faces.size()) - 1 : of[first];
    faces[of[f]].push_back(f);
  }
}

}  // namespace whittle
