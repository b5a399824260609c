#include "mesh/bounding_box.h"

namespace whittle {

Box boundingBox(const Points& positions) {
  Box box;
  for (Index v = 0; v < positions.rows(); ++v) box.extend(positions.row(v).transpose());
  return box;
}

}  // namespace whittle
