#include "methods/local_global/edges/edge_set.h"

#include <algorithm>

#include "methods/local_global/edges/face_edges.h"
#include "methods/local_global/edges/spokes_and_rims.h"

namespace whittle {

namespace {

/// Elements of a slice: 5 to 10 ms as wasm, on cold caches too.
constexpr Index kSlice = 16384;

}  // namespace

double EdgeSet::collectNext() {
  const ElementRange range{collected_, std::min(collected_ + kSlice, elementCount_)};
  collect(range);
  collected_ = range.end;
  if (collected_ < elementCount_) return static_cast<double>(collected_) / elementCount_;
  endCollecting();
  return 1;
}

std::unique_ptr<EdgeSet> makeEdgeSet(EdgeSetKind kind, const TriangleMesh& rest, const CornerScalars& halfCotangents) {
  if (kind == EdgeSetKind::faces) return std::make_unique<FaceEdges>(rest, halfCotangents);
  return std::make_unique<SpokesAndRims>(rest, halfCotangents);
}

Mat3 cornerGradients(const TriangleMesh& rest, const CornerScalars& halfCotangents, Index face) {
  const auto corner = [&](int k) -> Vec3 { return rest.positions.row(rest.triangles(face, k)).transpose(); };
  const auto c = halfCotangents.row(face);
  // Edges run 1→2, 2→0, 0→1 opposite to corners 0, 1, 2; a corner gains the edge that ends in it.
  const Vec3 edge0 = c[0] * (corner(2) - corner(1));
  const Vec3 edge1 = c[1] * (corner(0) - corner(2));
  const Vec3 edge2 = c[2] * (corner(1) - corner(0));
  Mat3 gradients;
  gradients << edge1 - edge2, edge2 - edge0, edge0 - edge1;
  return gradients;
}

}  // namespace whittle
