#include "mesh/bounding_box.h"

namespace whittle {

Box boundingBox(const TriangleMesh& mesh) {
  Box box;
  for (Index corner = 0; corner < mesh.triangles.size(); ++corner)
    box.extend(mesh.positions.row(mesh.triangles.data()[corner]).transpose());
  return box;
}

}  // namespace whittle
