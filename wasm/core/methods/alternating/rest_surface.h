#pragma once

#include <vector>

#include "geometry/curvature.h"
#include "geometry/feature_edges.h"
#include "mesh/edges.h"
#include "mesh/triangle_mesh.h"

namespace whittle {

/// A pair of faces that meet in an edge, as the transformation solve sees it.
struct Hinge {
  Index first, second;  // faces t and s
  Vec3 along;           // ê, unit, the shared edge
  Vec3 across;          // d̂, unit, between the vertices opposite to it
  double similarity;    // ω_f, 0 across a crease
};

/// What of the rest shape the energy reads, in the unit frame. Half edges 3f + i as in `MeshEdges`; sums over them count
/// an inner edge twice.
struct RestSurface {
  TriangleMesh mesh;
  MeshEdges edges;
  std::vector<FacePair> pairs;  // all pairs of faces on an edge
  Points halfEdges;             // ē, 3#F×3
  Scalars lengths;              // l̄, 3#F
  Points faceNormals;           // n̄, #F×3, unit
  Points edgeNormals;           // 3#F×3, unit: what the normal terms keep each half edge orthogonal to
  double averageLength = 0;     // L_avg, mean of l̄

  std::vector<Hinge> hinges;  // one for each pair
  Scalars sphericity;         // Γ, #F, 0 to 1
  Points keptDirections;      // c, #F×3: across the axis of a round part that keeps its radius; zero elsewhere

  Index vertexCount() const { return mesh.vertexCount(); }
  Index faceCount() const { return mesh.faceCount(); }
  Index halfEdgeCount() const { return 3 * mesh.faceCount(); }
};

/// Edge vectors of all half edges, 3#F×3.
void halfEdgeVectors(const Points& positions, const Triangles& triangles, Points& vectors);

/// Lengths, normals and pairs of a mesh whose faces all have an area.
RestSurface measureSurface(TriangleMesh mesh);

/// What the normal terms keep a half edge orthogonal to: its face's own normal, as printed, or the mean of both faces'
/// where they bend by less than an angle. The mean is orthogonal to the edge as well and free of the tilt that the
/// triangulation of a round part brings in, which lengthening would change: with own normals rods grow thicker.
void setEdgeNormals(RestSurface& surface, double meanBelow);

/// ω_f of each hinge, exp(−θ² / 2(30°)²), 0 from 75° on.
void setSimilarity(RestSurface& surface);

/// Takes similarity off where nobody sees it: between faces that are plane it makes the whole plane stretch evenly, holes
/// and all. A factor `least` + (1 − `least`)·clip(k/0.5, 0, 1), k the
/// strongest curvature of both faces.
void fadeSimilarity(RestSurface& surface, const Curvatures& curvatures, double least);

/// Takes similarity off where a round part that keeps its radius goes over into what is flat: a side may stretch up to
/// where its fillet begins. What curves both ways, as the ball at a corner, stays with the fillet.
void fadeBorders(RestSurface& surface, const Curvatures& curvatures, double least);

}  // namespace whittle
