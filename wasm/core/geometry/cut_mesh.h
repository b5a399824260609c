#pragma once

#include <vector>

#include "mesh/edges.h"

namespace whittle {

/// A mesh cut open along some of its edges. A cut vertex is a fan of faces around a vertex that hang together over edges
/// which are not cut: a vertex on a crease becomes one on each side of it, a vertex where a crease ends stays whole.
/// Besides the edges that are asked for, edges of three and more faces are cut, and those whose two faces have other
/// sides up, so that each piece is a surface with a side.
struct CutMesh {
  Triangles triangles;            // #F×3, into the cut vertices
  std::vector<Index> vertex;      // of the mesh, of each cut vertex; #cut
  std::vector<Index> start;       // #cut + 1: the neighbours of i are neighbours[start[i]] …
  std::vector<Index> neighbours;  // over edges; some twice, where a cut ends at both its ends

  /// @param cuts #E, edges to cut
  CutMesh(const Triangles& triangles, const MeshEdges& edges, const std::vector<bool>& cuts);

  Index count() const { return static_cast<Index>(vertex.size()); }
};

}  // namespace whittle
