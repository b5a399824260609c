#pragma once

#include <utility>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace whittle {

/// A mesh whose edges are halved, and halved again, until it has enough vertices. The vertices of the coarse mesh come
/// first, in their order.
class MidpointRefinement {
 public:
  MidpointRefinement(const TriangleMesh& coarse, Index leastVertices);

  const TriangleMesh& mesh() const { return mesh_; }
  /// The refined surface of other positions of the coarse vertices.
  void spread(const Points& coarse, Points& fine) const;

 private:
  void halveEdges();

  TriangleMesh mesh_;
  Index coarseCount_;
  std::vector<std::pair<Index, Index>> ends_;  // of the edge that each further vertex is the middle of
};

}  // namespace whittle
