#include "remeshing/derived_mesh.h"

#include <numeric>

namespace whittle {

DerivedMesh DerivedMesh::same(const TriangleMesh& mesh) {
  DerivedMesh result{mesh, std::vector<Index>(mesh.vertexCount()), std::vector<Index>(mesh.faceCount())};
  std::iota(result.vertexOrigin.begin(), result.vertexOrigin.end(), 0);
  std::iota(result.faceOrigin.begin(), result.faceOrigin.end(), 0);
  return result;
}

DerivedMesh DerivedMesh::then(DerivedMesh next) const {
  for (Index& v : next.vertexOrigin) v = v < 0 ? -1 : vertexOrigin[v];
  for (Index& f : next.faceOrigin) f = faceOrigin[f];
  return next;
}

}  // namespace whittle
