#pragma once

#include <vector>

#include "mesh/triangle_mesh.h"

namespace whittle {

/// A mesh that was made from another, its original, and what of it comes from where.
struct DerivedMesh {
  TriangleMesh mesh;
  std::vector<Index> vertexOrigin;  // #V: the vertex of the original that lies in the very same place, or −1
  std::vector<Index> faceOrigin;    // #F: the face of the original on or beside which the face lies

  /// The mesh itself, each element its own origin.
  static DerivedMesh same(const TriangleMesh& mesh);
  /// What was made from a derived mesh, `next`, as made from the original of this one.
  DerivedMesh then(DerivedMesh next) const;
};

}  // namespace whittle
