#include "geometry/surface.h"

namespace whittle {

namespace {

Vec3 doubledAreaVector(const Points& positions, const Triangles& triangles, Index f) {
  const Vec3 a = positions.row(triangles(f, 0)).transpose();
  const Vec3 b = positions.row(triangles(f, 1)).transpose();
  const Vec3 c = positions.row(triangles(f, 2)).transpose();
  return (b - a).cross(c - a);
}

}  // namespace

Scalars faceAreas(const Points& positions, const Triangles& triangles) {
  Scalars areas(triangles.rows());
  for (Index f = 0; f < triangles.rows(); ++f) areas[f] = 0.5 * doubledAreaVector(positions, triangles, f).norm();
  return areas;
}

Scalars barycentricAreas(const Points& positions, const Triangles& triangles) {
  Scalars areas = Scalars::Zero(positions.rows());
  for (Index f = 0; f < triangles.rows(); ++f) {
    const double share = doubledAreaVector(positions, triangles, f).norm() / 6;
    for (int k = 0; k < 3; ++k) areas[triangles(f, k)] += share;
  }
  return areas;
}

Points vertexNormals(const Points& positions, const Triangles& triangles) {
  Points normals = Points::Zero(positions.rows(), 3);
  Scalars areas = Scalars::Zero(positions.rows());
  for (Index f = 0; f < triangles.rows(); ++f) {
    const Vec3 vector = doubledAreaVector(positions, triangles, f);
    for (int k = 0; k < 3; ++k) {
      normals.row(triangles(f, k)) += vector.transpose();
      areas[triangles(f, k)] += vector.norm();
    }
  }
  for (Index v = 0; v < normals.rows(); ++v) {
    // A sum far below its terms is rounding: two sheets back to back have no normal, not a random one.
    const double length = normals.row(v).norm();
    if (length > 1e-10 * areas[v]) {
      normals.row(v) /= length;
    } else {
      normals.row(v).setZero();
    }
  }
  return normals;
}

}  // namespace whittle
