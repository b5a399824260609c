#pragma once

#include <cmath>

#include "base/types.h"
#include "geometry/smooth_fans.h"

namespace whittle {

/// Quality of a triangle, 4√3 area / Σ edge²: 1 for an equilateral one, 0 for one without area.
inline double triangleQuality(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double squares = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
  return squares > 0 ? 2 * std::sqrt(3.0) * (b - a).cross(c - a).norm() / squares : 0;
}

/// Area of each face, #F.
Scalars faceAreas(const Points& positions, const Triangles& triangles);

/// Barycentric area of each vertex, #V: a third of its faces' area. Sums to the area of the surface.
Scalars barycentricAreas(const Points& positions, const Triangles& triangles);
/// The same of each smooth fan, #fans.
Scalars barycentricAreas(const Points& positions, const Triangles& triangles, const SmoothFans& fans);

/// Mixed Voronoi area of each vertex, #V: of an acute face the part nearest to the vertex, of an obtuse one half of it
/// at the wide corner and a quarter at the others. Sums to the area of the surface.
Scalars mixedVoronoiAreas(const Points& positions, const Triangles& triangles);
/// The same of each smooth fan, #fans.
Scalars mixedVoronoiAreas(const Points& positions, const Triangles& triangles, const SmoothFans& fans);

/// Area-weighted vertex normals, #V×3, unit length; the zero vector where the faces cancel or there are none.
Points vertexNormals(const Points& positions, const Triangles& triangles);
/// Vertex normals without allocating: into `normals` (#V×3), `areas` (#V) for scratch.
void vertexNormals(const Points& positions, const Triangles& triangles, Points& normals, Scalars& areas);
/// The same of each smooth fan, #fans×3: a vertex that has one gets the very bits.
Points fanNormals(const Points& positions, const Triangles& triangles, const SmoothFans& fans);
/// Fan normals without allocating: into `normals` (#fans×3), `areas` (#fans) for scratch.
void fanNormals(const Points& positions, const Triangles& triangles, const SmoothFans& fans, Points& normals,
                Scalars& areas);

/// Unit face normals, #F×3; zero where a face has no area.
Points faceNormals(const Points& positions, const Triangles& triangles);
/// Face normals without allocating, into `normals` (#F×3).
void faceNormals(const Points& positions, const Triangles& triangles, Points& normals);
/// Unit face normals, #F×3; zero where rounding would decide, as on needles and caps that are lines but for it.
Points sureNormals(const Points& positions, const Triangles& triangles);

}  // namespace whittle
