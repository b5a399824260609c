#include "mesh/unit_frame.h"

#include "mesh/bounding_box.h"

namespace whittle {

UnitFrame UnitFrame::of(const Points& positions) {
  UnitFrame frame;
  // The mean of differences from one corner of the box: no cancellation for a mesh far from the origin.
  const Box box = boundingBox(positions);
  const Eigen::RowVector3d corner = box.min().transpose();
  frame.scale = box.sizes().maxCoeff();
  frame.center = (corner + (positions.rowwise() - corner).colwise().mean()).transpose();
  return frame;
}

}  // namespace whittle
