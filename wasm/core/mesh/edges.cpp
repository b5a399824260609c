#include "mesh/edges.h"

#include <algorithm>
#include <numeric>

namespace whittle {

namespace {

/// Half edges by their smaller end, and among those of one end by the larger: two counting sorts, in linear time.
std::vector<Index> sortedHalfEdges(const Triangles& triangles, Index vertexCount) {
  const auto ends = [&](Index h) {
    return std::minmax(triangles(faceOf(h), tailCorner(h)), triangles(faceOf(h), headCorner(h)));
  };
  std::vector<Index> order;
  for (Index h = 0; h < triangles.size(); ++h) {
    if (triangles(faceOf(h), tailCorner(h)) != triangles(faceOf(h), headCorner(h))) order.push_back(h);
  }
  std::vector<Index> next(vertexCount + 1), sorted(order.size());
  const auto sortBy = [&](auto&& key) {
    std::fill(next.begin(), next.end(), 0);
    for (const Index h : order) ++next[key(h) + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    for (const Index h : order) sorted[next[key(h)]++] = h;
    order.swap(sorted);
  };
  sortBy([&](Index h) { return ends(h).second; });
  sortBy([&](Index h) { return ends(h).first; });
  return order;
}

}  // namespace

MeshEdges::MeshEdges(const Triangles& triangles, Index vertexCount)
    : halfEdges(sortedHalfEdges(triangles, vertexCount)), ofHalfEdge(triangles.size(), -1) {
  for (Index place = 0; place < static_cast<Index>(halfEdges.size()); ++place) {
    const Index h = halfEdges[place];
    const auto [low, high] = std::minmax(triangles(faceOf(h), tailCorner(h)), triangles(faceOf(h), headCorner(h)));
    if (ends.empty() || ends.back() != std::array<Index, 2>{low, high}) {
      ends.push_back({low, high});
      start.push_back(place);
    }
    ofHalfEdge[h] = count() - 1;
  }
  start.push_back(static_cast<Index>(halfEdges.size()));
}

}  // namespace whittle
