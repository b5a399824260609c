#pragma once

#include <vector>

#include "mesh/triangle_mesh.h"
#include "simd/symmetric_eigen.h"

namespace whittle {

/// Face normals that a developable surface near the present one would have (2021, App. E). The normals n of a vertex'
/// ring, with C = Σ area n nᵀ and its eigenvalues e0 ≥ e1 ≥ e2, belong to one common plane if e2 = 0, and are all the
/// same if e1 = 0 too. So every vertex drops the direction of e2 from the normals around it, and that of e1 too where
/// e1 / e0 lies below a threshold: there it wants to be flat, elsewhere bent one way, and between flat places creases
/// are left. A face takes the mean of its corners' proposals.
class DevelopableNormals {
 public:
  /// @param creases share of the vertices of the rest shape, those of the largest e1 / e0, that may stay bent. e1 / e0
  ///   itself falls to a quarter with each subdivision, its quantiles stay with the shape
  void prepare(const TriangleMesh& rest, double creases);

  /// Looks at positions of the mesh. Allocates nothing.
  void observe(const Points& positions);

  /// The target of a face, of any length; zero where there is none.
  Vec3 operator()(Index face) const;

 private:
  /// A symmetric matrix of a vertex: its C, then what it does to normals.
  struct Ring {
    LaneRow upper;  // xx xy xz yy
    LaneRow lower;  // yz zz
  };

  void gatherRings(const Points& positions);
  /// Quantile of e1 / e0 over the rings of the rest shape.
  double quantileOfBend(double share) const;

  const Triangles* triangles_ = nullptr;
  float threshold_ = 0;
  std::vector<LaneRow> normals_;  // #F, unit or zero
  std::vector<Ring> rings_;       // #V, filled up to whole batches
};

}  // namespace whittle
