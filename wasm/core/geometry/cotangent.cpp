#include "geometry/cotangent.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace whittle {

namespace {

/// Twice the area is at least this share of the longest edge squared. The numerators alone form a semidefinite matrix,
/// so any positive floor keeps L semidefinite; this one keeps its condition within reach of double precision.
constexpr double kAreaFloor = 1e-8;

}  // namespace

CornerScalars halfCotangents(const Points& positions, const Triangles& triangles) {
  CornerScalars cotangents(triangles.rows(), 3);
  for (Index f = 0; f < triangles.rows(); ++f) {
    Vec3 edge[3];  // edge[k] is opposite to corner k
    double longest = 0;
    double shortest = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
      const Index from = triangles(f, (k + 1) % 3);
      const Index to = triangles(f, (k + 2) % 3);
      edge[k] = (positions.row(to) - positions.row(from)).transpose();
      longest = std::max(longest, edge[k].squaredNorm());
      shortest = std::min(shortest, edge[k].squaredNorm());
    }
    if (shortest == 0) {
      cotangents.row(f).setZero();
      continue;
    }
    const double doubledArea = std::max(edge[0].cross(edge[1]).norm(), kAreaFloor * longest);
    for (int k = 0; k < 3; ++k) {
      cotangents(f, k) = -0.5 * edge[(k + 1) % 3].dot(edge[(k + 2) % 3]) / doubledArea;
    }
  }
  return cotangents;
}

SparseMatrix cotangentLaplacian(const Triangles& triangles, const CornerScalars& halfCotangents, Index vertexCount) {
  std::vector<Eigen::Triplet<double, Index>> entries;
  entries.reserve(12 * triangles.rows());
  for (Index f = 0; f < triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const Index i = triangles(f, (k + 1) % 3);
      const Index j = triangles(f, (k + 2) % 3);
      const double c = halfCotangents(f, k);
      entries.emplace_back(i, j, -c);
      entries.emplace_back(j, i, -c);
      entries.emplace_back(i, i, c);
      entries.emplace_back(j, j, c);
    }
  }
  SparseMatrix laplacian(vertexCount, vertexCount);
  laplacian.setFromTriplets(entries.begin(), entries.end());
  return laplacian;
}

}  // namespace whittle
