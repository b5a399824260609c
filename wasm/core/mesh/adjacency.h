#pragma once

#include <vector>

#include "base/types.h"

namespace whittle {

/// Connected parts of a mesh. A vertex that no face uses is a part of its own.
struct Components {
  std::vector<Index> ofVertex;  // #V, part of each vertex, numbered by first vertex
  Index count = 0;

  /// Part of each face, #F.
  std::vector<Index> ofFaces(const Triangles& triangles) const;
};

/// Parts by shared vertices (edges of faces connect, so a bow-tie vertex joins its two fans).
Components connectedComponents(const Triangles& triangles, Index vertexCount);

/// Part of each face, #F, by shared edges: faces that meet in no more than a vertex hang by no edge.
std::vector<Index> partsByEdges(const Triangles& triangles, Index vertexCount);

/// The face corners at each vertex: of v, corners[start[v]] … corners[start[v + 1] − 1], ascending. Corner k of face f
/// is 3f + k.
struct Fans {
  std::vector<Index> start;    // #V + 1
  std::vector<Index> corners;  // 3 #F

  Fans(const Triangles& triangles, Index vertexCount);
};

/// The other two corners of a face. The edge to one of them is opposite to the other.
inline constexpr int kOtherCorners[3][2] = {{1, 2}, {0, 2}, {0, 1}};

/// How many undirected edges have one face, and how many have three or more. Edges of zero length (a vertex used twice
/// by a face) are left out.
struct EdgeCounts {
  Index boundary = 0;
  Index nonManifold = 0;
};

EdgeCounts countEdges(const Triangles& triangles, const Fans& fans);

}  // namespace whittle
