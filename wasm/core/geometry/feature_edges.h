#pragma once

#include <vector>

#include "mesh/edges.h"

namespace whittle {

/// Two faces that meet in an edge.
struct FacePair {
  Index edge;
  Index first, second;  // half edges along it, first < second
  double angle;         // radians, 0 … π, between the unit normals; 0 where a face has no area
};

/// The pairs of faces on each edge, edge by edge: none of a border edge, one of an edge of two faces, all of an edge of
/// more, of which beyond `kMostFacesPaired` each is paired with so many before it. Where both half edges of a pair run
/// the same way, the faces have other sides up, and the normal of the second counts turned round: a flat pair has the
/// angle 0 however its faces are turned, a face folded back onto another π.
std::vector<FacePair> facePairs(const Points& positions, const Triangles& triangles, const MeshEdges& edges);

/// Enough for every edge of a surface, and never a square of the mesh.
constexpr Index kMostFacesPaired = 8;

/// The feature edges, #E: those with a pair of faces that bends by more than an angle (radians). An edge of three faces
/// and more is one below 60°, for no three planes through a line all continue each other. A border edge is none, for
/// nothing bends there.
std::vector<bool> featureEdges(const std::vector<FacePair>& pairs, Index edgeCount, double angle);

}  // namespace whittle
