#include "mesh/unit_frame.h"

namespace whittle {

UnitFrame UnitFrame::of(const Points& positions) {
  UnitFrame frame;
  // The mean of differences from one corner of the box: no cancellation for a mesh far from the origin.
  const Eigen::RowVector3d corner = positions.colwise().minCoeff();
  frame.scale = (positions.colwise().maxCoeff() - corner).maxCoeff();
  frame.center = (corner + (positions.rowwise() - corner).colwise().mean()).transpose();
  return frame;
}

}  // namespace whittle
