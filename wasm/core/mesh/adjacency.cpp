#include "mesh/adjacency.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace whittle {

namespace {

Index findRoot(std::vector<Index>& parent, Index v) {
  while (parent[v] != v) {
    parent[v] = parent[parent[v]];  // halve the path, so that long strips stay linear
    v = parent[v];
  }
  return v;
}

}  // namespace

Components connectedComponents(const Triangles& triangles, Index vertexCount) {
  std::vector<Index> parent(vertexCount);
  std::iota(parent.begin(), parent.end(), 0);
  for (Index f = 0; f < triangles.rows(); ++f) {
    for (int k = 1; k < 3; ++k) {
      const Index a = findRoot(parent, triangles(f, 0));
      const Index b = findRoot(parent, triangles(f, k));
      parent[std::max(a, b)] = std::min(a, b);
    }
  }

  Components components;
  components.ofVertex.resize(vertexCount);
  for (Index v = 0; v < vertexCount; ++v) {
    const Index root = findRoot(parent, v);  // the smallest vertex of the part, so numbered before its others
    components.ofVertex[v] = root == v ? components.count++ : components.ofVertex[root];
  }
  return components;
}

EdgeCounts countEdges(const Triangles& triangles) {
  std::vector<std::pair<Index, Index>> edges;
  edges.reserve(3 * triangles.rows());
  for (Index f = 0; f < triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const Index a = triangles(f, k);
      const Index b = triangles(f, (k + 1) % 3);
      if (a != b) edges.emplace_back(std::min(a, b), std::max(a, b));
    }
  }
  std::sort(edges.begin(), edges.end());

  EdgeCounts counts;
  for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
    while (last < edges.size() && edges[last] == edges[first]) ++last;
    counts.boundary += last - first == 1;
    counts.nonManifold += last - first > 2;
  }
  return counts;
}

Index countDuplicateFaces(const Triangles& triangles) {
  std::vector<std::array<Index, 3>> faces(triangles.rows());
  for (Index f = 0; f < triangles.rows(); ++f) {
    faces[f] = {triangles(f, 0), triangles(f, 1), triangles(f, 2)};
    std::sort(faces[f].begin(), faces[f].end());
  }
  std::sort(faces.begin(), faces.end());
  return static_cast<Index>(faces.end() - std::unique(faces.begin(), faces.end()));
}

}  // namespace whittle
