#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>

namespace whittle {

using Index = std::int32_t;

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

/// One point or vector per row (#V×3), stored xyz xyz … so that it crosses to JavaScript without a copy.
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
/// One number per row.
using Scalars = Eigen::VectorXd;
/// Vertex indices of each face (#F×3).
using Triangles = Eigen::Matrix<Index, Eigen::Dynamic, 3, Eigen::RowMajor>;
/// One number per face corner (#F×3); for edge quantities, corner k stands for the edge opposite to it.
using CornerScalars = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

}  // namespace whittle
