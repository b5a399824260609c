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
  halfCotangents(positions, triangles, cotangents);
  return cotangents;
}

void halfCotangents(const Points& positions, const Triangles& triangles, CornerScalars& cotangents) {
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
}

SparseMatrix cotangentLaplacian(const Triangles& triangles, const CornerScalars& halfCotangents, Index vertexCount) {
  // Half the matrix in triplets, the other half by symmetry: the triplets are the peak of the memory use.
  std::vector<Eigen::Triplet<double, Index>> lower;
  lower.reserve(3 * triangles.rows() + vertexCount);
  Scalars diagonal = Scalars::Zero(vertexCount);
  for (Index f = 0; f < triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const Index i = triangles(f, (k + 1) % 3);
      const Index j = triangles(f, (k + 2) % 3);
      if (i == j) continue;
      const double c = halfCotangents(f, k);
      lower.emplace_back(std::max(i, j), std::min(i, j), -c);
      diagonal[i] += c;
      diagonal[j] += c;
    }
  }
  for (Index v = 0; v < vertexCount; ++v) lower.emplace_back(v, v, diagonal[v]);
  SparseMatrix half(vertexCount, vertexCount);
  half.setFromTriplets(lower.begin(), lower.end());
  return half.selfadjointView<Eigen::Lower>();
}

LaplacianPattern::LaplacianPattern(const Triangles& triangles, Index vertexCount, const std::vector<Index>& held)
    : triangles_(triangles), isHeld_(vertexCount, false), edgePlaces_(triangles.rows(), 3) {
  for (const Index v : held) isHeld_[v] = true;
  lower_ = cotangentLaplacian(triangles, CornerScalars::Ones(triangles.rows(), 3), vertexCount).triangularView<Eigen::Lower>();
  lower_.makeCompressed();
  for (Index f = 0; f < triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const auto [column, row] = std::minmax(triangles(f, (k + 1) % 3), triangles(f, (k + 2) % 3));
      const Index* begin = lower_.innerIndexPtr() + lower_.outerIndexPtr()[column];
      const Index* end = lower_.innerIndexPtr() + lower_.outerIndexPtr()[column + 1];
      const bool isFree = row != column && !isHeld_[row] && !isHeld_[column];
      edgePlaces_(f, k) = isFree ? static_cast<Index>(std::lower_bound(begin, end, row) - lower_.innerIndexPtr()) : kNowhere;
    }
  }
}

const SparseMatrix& LaplacianPattern::fill(const CornerScalars& halfCotangents) {
  double* values = lower_.valuePtr();
  const Index* diagonal = lower_.outerIndexPtr();  // sorted columns of a lower triangle begin with it
  std::fill_n(values, lower_.nonZeros(), 0.0);
  for (Index f = 0; f < triangles_.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const Index i = triangles_(f, (k + 1) % 3), j = triangles_(f, (k + 2) % 3);
      if (i == j) continue;
      const double c = halfCotangents(f, k);
      if (edgePlaces_(f, k) != kNowhere) values[edgePlaces_(f, k)] -= c;
      values[diagonal[i]] += c;
      values[diagonal[j]] += c;
    }
  }
  for (Index v = 0; v < lower_.cols(); ++v) {
    if (isHeld_[v]) values[diagonal[v]] = 1;
  }
  return lower_;
}

}  // namespace whittle
