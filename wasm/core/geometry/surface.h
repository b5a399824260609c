#pragma once

#include "base/types.h"

namespace whittle {

/// Area of each face, #F.
Scalars faceAreas(const Points& positions, const Triangles& triangles);

/// Barycentric area of each vertex, #V: a third of its faces' area. Sums to the area of the surface.
Scalars barycentricAreas(const Points& positions, const Triangles& triangles);

/// Area-weighted vertex normals, #V×3, unit length; the zero vector where the faces cancel or there are none.
Points vertexNormals(const Points& positions, const Triangles& triangles);

}  // namespace whittle
