#include "mesh/adjacency.h"

#include <algorithm>
#include <numeric>

#include "base/tiering.h"
#include "mesh/disjoint_sets.h"

namespace whittle {

namespace {

/// Counts the edges from v to higher vertices.
/// @param faceCounts of the edge to each vertex, all zero before and after
WHITTLE_OWN_FUNCTION void countEdgesAt(Index v, const Triangles& triangles, const Fans& fans, Index* faceCounts,
                                       EdgeCounts& counts) {
  const auto forEachOther = [&](auto&& visit) {
    for (Index p = fans.start[v]; p < fans.start[v + 1]; ++p) {
      const Index f = fans.corners[p] / 3;
      for (const int k : kOtherCorners[fans.corners[p] % 3]) {
        if (triangles(f, k) > v) visit(faceCounts[triangles(f, k)]);
      }
    }
  };
  forEachOther([](Index& faces) { ++faces; });
  forEachOther([&](Index& faces) {
    counts.boundary += faces == 1;
    counts.nonManifold += faces > 2;
    faces = 0;
  });
}

}  // namespace

Components connectedComponents(const Triangles& triangles, Index vertexCount) {
  DisjointSets parts(vertexCount);
  for (Index f = 0; f < triangles.rows(); ++f) {
    for (int k = 1; k < 3; ++k) parts.join(triangles(f, 0), triangles(f, k));
  }

  Components components;
  components.ofVertex.resize(vertexCount);
  for (Index v = 0; v < vertexCount; ++v) {
    const Index root = parts.find(v);  // the smallest vertex of the part, so numbered before its others
    components.ofVertex[v] = root == v ? components.count++ : components.ofVertex[root];
  }
  return components;
}

std::vector<Index> Components::ofFaces(const Triangles& triangles) const {
  std::vector<Index> parts(triangles.rows());
  for (Index f = 0; f < triangles.rows(); ++f) parts[f] = ofVertex[triangles(f, 0)];
  return parts;
}

std::vector<Index> partsByEdges(const Triangles& triangles, Index vertexCount) {
  const Fans fans(triangles, vertexCount);
  DisjointSets parts(static_cast<Index>(triangles.rows()));
  std::vector<Index> faceAt(vertexCount, -1);
  const auto forEachUpward = [&](Index v, auto&& visit) {
    for (Index p = fans.start[v]; p < fans.start[v + 1]; ++p) {
      const Index f = fans.corners[p] / 3;
      for (const int k : kOtherCorners[fans.corners[p] % 3]) {
        if (triangles(f, k) > v) visit(f, faceAt[triangles(f, k)]);
      }
    }
  };
  for (Index v = 0; v < vertexCount; ++v) {
    forEachUpward(v, [&](Index f, Index& last) {
      if (last >= 0) parts.join(last, f);
      last = f;
    });
    forEachUpward(v, [](Index, Index& last) { last = -1; });
  }
  std::vector<Index> partOfFace(triangles.rows());
  for (Index f = 0; f < static_cast<Index>(partOfFace.size()); ++f) partOfFace[f] = parts.find(f);
  return partOfFace;
}

Fans::Fans(const Triangles& triangles, Index vertexCount) : start(vertexCount + 1, 0), corners(triangles.size()) {
  const Index* const vertices = triangles.data();
  const Index count = static_cast<Index>(triangles.size());
  for (Index i = 0; i < count; ++i) ++start[vertices[i] + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<Index> next(start.begin(), start.end() - 1);
  for (Index i = 0; i < count; ++i) corners[next[vertices[i]]++] = i;
}

EdgeCounts countEdges(const Triangles& triangles, const Fans& fans) {
  EdgeCounts counts;
  std::vector<Index> faceCounts(fans.start.size(), 0);
  for (Index v = 0; v + 1 < static_cast<Index>(fans.start.size()); ++v)
    countEdgesAt(v, triangles, fans, faceCounts.data(), counts);
  return counts;
}

}  // namespace whittle
