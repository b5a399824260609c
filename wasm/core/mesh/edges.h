#pragma once

#include <array>
#include <vector>

#include "base/types.h"

namespace whittle {

/// The undirected edges of a mesh and the half edges of faces along them. Half edge 3f + i goes from corner i of face f
/// to corner (i + 1) % 3; the corner opposite to it is (i + 2) % 3. A border edge has one half edge, a non-manifold one
/// three or more. A side of no length, between two corners in the same vertex, is no edge.
struct MeshEdges {
  std::vector<std::array<Index, 2>> ends;  // #E, smaller vertex first; edges rise by their ends
  std::vector<Index> start;                // #E + 1: the half edges of edge e are halfEdges[start[e]] …, ascending
  std::vector<Index> halfEdges;
  std::vector<Index> ofHalfEdge;  // 3 #F, or −1 for a side of no length

  MeshEdges() = default;
  MeshEdges(const Triangles& triangles, Index vertexCount);

  Index count() const { return static_cast<Index>(ends.size()); }
  Index faceCountAt(Index edge) const { return start[edge + 1] - start[edge]; }
};

inline Index faceOf(Index halfEdge) { return halfEdge / 3; }
/// The corners from which a half edge comes, to which it goes, and which lies opposite.
inline int tailCorner(Index halfEdge) { return halfEdge % 3; }
inline int headCorner(Index halfEdge) { return (halfEdge + 1) % 3; }
inline int oppositeCorner(Index halfEdge) { return (halfEdge + 2) % 3; }

}  // namespace whittle
