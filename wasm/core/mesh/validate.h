#pragma once

#include "base/status.h"
#include "mesh/triangle_mesh.h"

namespace whittle {

/// The one door: refuses what no method can work on, names the bad element and says what to do. Fails with `noFaces`,
/// `tooLarge`, `indexOutOfRange` (element: face), `notFinite` (element: vertex) or `zeroExtent`. Everything else
/// (holes, several parts, non-manifold edges, zero-area faces, unused vertices wherever they are) is let through and
/// reported.
Status validate(const TriangleMesh& mesh);

/// What the user may want to know of a valid mesh. Edges and parts are those of the faces.
struct MeshReport {
  Index vertices = 0;
  Index faces = 0;
  Index components = 0;        // parts with at least one face
  Index typicalPart = 0;       // vertices of the part of which the middle vertex is, parts in order of their size
  Index boundaryEdges = 0;     // edges with one face
  Index nonManifoldEdges = 0;  // edges with three faces or more
  Index degenerateFaces = 0;   // faces of zero area, to rounding
  Index isolatedVertices = 0;  // vertices without a face
  Index farVertices = 0;       // vertices of faces so far away that they do not count for the unit frame
  Vec3 min = Vec3::Zero();     // box of the vertices that faces use
  Vec3 max = Vec3::Zero();
};

MeshReport inspect(const TriangleMesh& mesh);

/// Twice the area of a face over the square of its longest edge: 0.87 when equilateral, 0 when degenerate.
double thickness(const TriangleMesh& mesh, Index face);

/// Faces thinner than this have no usable shape; their angles are limited (see `halfCotangents`).
inline constexpr double kDegenerateThickness = 1e-8;

}  // namespace whittle
