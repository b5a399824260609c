#pragma once

#include "mesh/triangle_mesh.h"

namespace whittle {

/// The frame in which every solver works: longest side of the box 1, vertex mean at the origin. In it λ, tolerances and
/// thresholds mean the same whatever the file's units. Box and mean are those of `significantVertices`.
struct UnitFrame {
  Vec3 center = Vec3::Zero();
  double scale = 1;  // file units per unit length

  /// The frame of a mesh that `validate` has let through.
  static UnitFrame of(const TriangleMesh& mesh);

  Vec3 toUnit(const Vec3& point) const { return (point - center) / scale; }
  Vec3 toFile(const Vec3& point) const { return center + scale * point; }
};

}  // namespace whittle
