#include "mesh/unit_frame.h"

#include <vector>

#include "mesh/bounding_box.h"
#include "mesh/significant_vertices.h"

namespace whittle {

UnitFrame UnitFrame::of(const TriangleMesh& mesh) {
  const std::vector<Index> vertices = significantVertices(mesh);
  Points positions(vertices.size(), 3);
  for (std::size_t i = 0; i < vertices.size(); ++i) positions.row(i) = mesh.positions.row(vertices[i]);
  Box box;
  for (Index i = 0; i < positions.rows(); ++i) box.extend(positions.row(i).transpose());
  UnitFrame frame;
  // The mean of differences from one corner of the box: no cancellation for a mesh far from the origin.
  const Eigen::RowVector3d corner = box.min().transpose();
  frame.scale = box.sizes().maxCoeff();
  frame.center = (corner + (positions.rowwise() - corner).colwise().mean()).transpose();
  return frame;
}

}  // namespace whittle
