#pragma once

#include "base/status.h"
#include "targets/direction_grid.h"

namespace whittle {

/// A style as data (2021, §3.1): which normal the output is to have where the input has a given one.
struct GaussMapData {
  enum class Kind {
    closest,    // the nearest of `normals` (#N×3), the faces of a convex shape
    perVertex,  // `points` (#V×3) and `triangles` are a style on the sphere; a normal for each point, interpolated
    perFace,    // a normal for each triangle, for faceted styles
  };
  Kind kind = Kind::closest;
  Points normals = Points(0, 3);
  Points points = Points(0, 3);           // of any length but zero; they stand for directions
  Triangles triangles = Triangles(0, 3);  // counter-clockwise from outside
};

bool operator==(const GaussMapData& a, const GaussMapData& b);

/// Fails with `badParameter` where counts do not fit, an index is out of range or a vector is not finite or zero.
Status validateGaussMap(const GaussMapData& data);

/// The map, ready for lookups in constant time.
///
/// Where it jumps from one normal to another, a normal is looked up where a small fixed turn takes it. A whole side of a
/// shape may lie between two normals of the style; rounding would choose for each of its triangles by itself, and the
/// side would crumple. So all take the same, and the opposite side the opposite one.
class GaussMap {
 public:
  /// The axis of the turn by which ties between two of the style's normals are decided: no symmetry's, and the same for
  /// every style, so that the order of its normals says nothing.
  static const Vec3 kTieAxis;

  /// @param data valid
  explicit GaussMap(GaussMapData data);

  const GaussMapData& data() const { return data_; }

  /// The target of a normal of any length, a unit vector; zero for zero. Where triangles leave gaps, that of the
  /// nearest one. Allocates nothing.
  Vec3 operator()(const Vec3& n) const;

 private:
  void collectClosest();
  void collectTriangles();
  Index closest(const Vec3& n) const;
  /// The triangle around a direction and its weights there (barycentric in the central projection).
  Index locate(const Vec3& n, Vec3& weights) const;

  GaussMapData data_;
  Points normals_, points_;  // of unit length
  DirectionGrid grid_;
  std::vector<Mat3> planes_;  // #F: rows p_j × p_k, so that planes n are the weights of n up to a factor
};

}  // namespace whittle
