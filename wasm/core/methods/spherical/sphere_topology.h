#pragma once

#include "base/status.h"
#include "mesh/triangle_mesh.h"

namespace whittle {

/// Refuses with `unsuitableMesh` what cannot be mapped to a sphere: several parts, degenerate faces, holes, edges of
/// three faces, faces that disagree about the outside, vertices where sheets merely touch, and handles and tunnels
/// (genus > 0). Vertices without a face are let through. The sentence names a place and what to do, the element is a
/// vertex, or a face where it is about faces.
Status requireSphere(const TriangleMesh& mesh);

/// Number of triangles that are turned over or have no area as seen from `center`, around which all points lie on a
/// sphere.
Index countFolded(const Triangles& triangles, const Points& positions, const Vec3& center);

}  // namespace whittle
