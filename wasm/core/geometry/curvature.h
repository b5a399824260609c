#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "geometry/cut_mesh.h"

namespace whittle {

/// Principal curvatures of faces, in 1 / length of the positions. Positive is convex: 1 / r on a sphere of radius r
/// whose normals point outwards.
struct Curvatures {
  Scalars larger;   // k1, #F
  Scalars smaller;  // k2 ≤ k1, #F
  /// Unit directions in the faces' planes of the curvature with the larger magnitude, #F×3; zero where all directions
  /// curve alike. Their sign means nothing.
  Points direction;

  double strongest(Index face) const { return std::max(std::abs(larger[face]), std::abs(smaller[face])); }
  double weakest(Index face) const { return std::min(std::abs(larger[face]), std::abs(smaller[face])); }
  /// (k1 − k2) / (max |k| + 10⁻³): 0 on a sphere, 1 on a cylinder, up to 2 on a saddle, 0 on a plane.
  double anisotropy(Index face) const { return (larger[face] - smaller[face]) / (strongest(face) + 1e-3); }
};

/// Measures principal curvatures: a quadric is fitted to the 3-ring of each vertex, on the mesh cut open along features,
/// so that a vertex on a crease has a quadric for each side; a face gets the mean of its corners. Vertices without
/// enough around them, as on two lone faces, count as flat where nothing says that they are not. Goes slice by slice,
/// in linear time.
class CurvatureEstimate {
 public:
  /// @param positions #V×3, triangles #F×3 and their edges, all to be kept by the caller until the end
  /// @param features #E, edges across which no quadric reaches
  CurvatureEstimate(const Points& positions, const Triangles& triangles, const MeshEdges& edges,
                    std::vector<bool> features);

  /// Does a slice of some 10 ms; returns the share that is done, 1 at the end.
  double next();
  /// The curvatures, once all is done.
  Curvatures take() { return std::move(result_); }

 private:
  /// Principal curvatures at a cut vertex, with the direction of the first.
  struct Principal {
    double larger = 0, smaller = 0;
    Vec3 direction = Vec3::Zero();
  };

  void prepare();
  void collectRings(Index vertex);
  Principal fit(Index vertex) const;
  void average(Index face);
  Vec3 at(Index cutVertex) const { return positions_.row(cut_->vertex[cutVertex]).transpose(); }

  const Points& positions_;
  const Triangles& triangles_;
  const MeshEdges& edges_;
  std::vector<bool> features_;
  std::optional<CutMesh> cut_;
  Points normals_;                    // #cut×3, unit or zero
  std::vector<Principal> principal_;  // #cut
  Index nextVertex_ = 0, nextFace_ = 0;
  std::vector<Index> ring_;      // cut vertices around the present one, nearest rings first
  std::vector<Index> seenFrom_;  // #cut, the vertex whose rings one was in last
  Curvatures result_;
};

}  // namespace whittle
