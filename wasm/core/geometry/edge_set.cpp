#include "geometry/edge_set.h"

namespace whittle {

namespace {

/// How many elements see each face's edges: its three corners, or itself.
double visits(EdgeSetKind kind) { return kind == EdgeSetKind::faces ? 1 : 3; }

/// Σ_e c_e |x_e|² over the edges of a face, given two edges that leave corner 0.
double edgeEnergy(const Eigen::RowVector3d& toSecond, const Eigen::RowVector3d& toThird, const auto& c) {
  return c[0] * (toThird - toSecond).squaredNorm() + c[1] * toThird.squaredNorm() + c[2] * toSecond.squaredNorm();
}

}  // namespace

EdgeSet::EdgeSet(EdgeSetKind kind, const TriangleMesh& rest)
    : kind_(kind),
      rest_(rest),
      halfCotangents_(whittle::halfCotangents(rest.positions, rest.triangles)),
      secondGradient_(rest.faceCount(), 3),
      thirdGradient_(rest.faceCount(), 3) {
  for (Index f = 0; f < rest.faceCount(); ++f) {
    const auto corner = [&](int k) { return rest.positions.row(rest_.triangles(f, k)); };
    const auto c = halfCotangents_.row(f);
    // Edges run 1→2, 2→0, 0→1 opposite to corners 0, 1, 2; a corner gains the edge that ends in it.
    const Eigen::RowVector3d edge0 = c[0] * (corner(2) - corner(1));
    const Eigen::RowVector3d edge1 = c[1] * (corner(0) - corner(2));
    const Eigen::RowVector3d edge2 = c[2] * (corner(1) - corner(0));
    secondGradient_.row(f) = edge2 - edge0;
    thirdGradient_.row(f) = edge0 - edge1;
    restEnergy_ += visits(kind_) * edgeEnergy(corner(1) - corner(0), corner(2) - corner(0), c);
  }
}

double EdgeSet::gatherCovariances(const Points& output, std::vector<Mat3>& covariances) const {
  for (Mat3& M : covariances) M.setZero();
  double outputEnergy = 0;
  for (Index f = 0; f < rest_.faceCount(); ++f) {
    const auto first = output.row(rest_.triangles(f, 0));
    const Eigen::RowVector3d toSecond = output.row(rest_.triangles(f, 1)) - first;
    const Eigen::RowVector3d toThird = output.row(rest_.triangles(f, 2)) - first;
    outputEnergy += edgeEnergy(toSecond, toThird, halfCotangents_.row(f));

    const Mat3 S = 2 * (secondGradient_.row(f).transpose() * toSecond + thirdGradient_.row(f).transpose() * toThird);
    if (kind_ == EdgeSetKind::faces) {
      covariances[f] = S;
    } else {
      for (int k = 0; k < 3; ++k) covariances[rest_.triangles(f, k)] += S;
    }
  }
  return restEnergy_ + visits(kind_) * outputEnergy;
}

Mat3 EdgeSet::meanRotation(const std::vector<Mat3>& rotations, Index face) const {
  if (kind_ == EdgeSetKind::faces) return rotations[face];
  const auto corners = rest_.triangles.row(face);
  return (rotations[corners[0]] + rotations[corners[1]] + rotations[corners[2]]) / 3;
}

void EdgeSet::scatterResidual(const std::vector<Mat3>& rotations, const Points& output, Points& residual) const {
  residual.setZero();
  for (Index f = 0; f < rest_.faceCount(); ++f) {
    const auto corners = rest_.triangles.row(f);
    const auto c = halfCotangents_.row(f);
    const Mat3 R = meanRotation(rotations, f);
    const Eigen::RowVector3d toSecond = output.row(corners[1]) - output.row(corners[0]);
    const Eigen::RowVector3d toThird = output.row(corners[2]) - output.row(corners[0]);
    // What the rotated rest edges ask of a corner, less what the output's edges give it.
    const Eigen::RowVector3d opposite = c[0] * (toThird - toSecond);
    const Eigen::RowVector3d second = (R * secondGradient_.row(f).transpose()).transpose() - c[2] * toSecond + opposite;
    const Eigen::RowVector3d third = (R * thirdGradient_.row(f).transpose()).transpose() - c[1] * toThird - opposite;
    residual.row(corners[1]) += second;
    residual.row(corners[2]) += third;
    residual.row(corners[0]) -= second + third;
  }
}

}  // namespace whittle
