#pragma once

#include <vector>

#include "base/types.h"

namespace whittle {

/// The smooth fans of a surface: around each vertex, the faces that hang together across edges which bend by no more
/// than 55°. Between the octagon's 45° and the hexagon's 60°, so that rounding decides neither. A vertex of a smooth
/// surface has one fan; the corner of a block has three, and each of them a normal of its own where the vertex's is the
/// diagonal. An edge of several faces joins all those pairs that bend little; a face without area bends nothing, and
/// what lies on both sides of it meets. Faces within 27.5° of one direction are one fan, whether or not they meet.
struct SmoothFans {
  std::vector<Index> start;  // #V + 1: the fans of vertex v are start[v] … start[v + 1] − 1, one at least
  Triangles ofCorner;        // #F×3: the fan of each corner; empty where no vertex has more than one

  Index count() const { return start.empty() ? 0 : start.back(); }
  bool areVertices() const { return ofCorner.rows() == 0; }
  Index countAt(Index vertex) const { return start[vertex + 1] - start[vertex]; }
};

SmoothFans smoothFans(const Points& positions, const Triangles& triangles);

}  // namespace whittle
