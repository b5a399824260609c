#include "methods/alternating/kept_sizes.h"

#include <cmath>

namespace whittle {

namespace {

constexpr double kSeen = 0.03;

/// How long a unit vector in a face's plane becomes.
double stretch(const RestSurface& surface, Index face, const Vec3& direction, const Points& positions) {
  const Triangles& triangles = surface.mesh.triangles;
  Eigen::Matrix<double, 3, 2> before, after;
  for (int k = 0; k < 2; ++k) {
    before.col(k) = surface.halfEdges.row(3 * face + k).transpose();
    after.col(k) = (positions.row(triangles(face, k + 1)) - positions.row(triangles(face, k))).transpose();
  }
  const Eigen::Matrix2d products = before.transpose() * before;
  const Eigen::Vector2d shares = products.inverse() * (before.transpose() * direction);
  return (after * shares).norm();
}

double sizeOf(const RestSurface& surface, const CylinderPatch& patch, const Points& positions) {
  double sum = 0, areas = 0;
  for (const Index f : patch.faces) {
    const Vec3 first = surface.halfEdges.row(3 * f).transpose(), second = surface.halfEdges.row(3 * f + 1).transpose();
    const double area = first.cross(second).norm();
    const Vec3 normal = surface.faceNormals.row(f).transpose();
    const Vec3 across = patch.axis.cross(normal).stableNormalized();
    if (!(area > 0)) continue;
    sum += area * stretch(surface, f, across, positions);
    areas += area;
  }
  return areas > 0 ? sum / areas : 1;
}

}  // namespace

SizeReport findChangedSizes(const RestSurface& surface, const std::vector<CylinderPatch>& patches,
                            const std::vector<bool>& kept, const Points& positions) {
  SizeReport report;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    if (!kept[p]) continue;
    const double size = sizeOf(surface, patches[p], positions);
    if (std::abs(size - 1) > kSeen) ++report.changed;
    if (std::abs(size - 1) > std::abs(report.most - 1)) report.most = size;
  }
  return report;
}

}  // namespace whittle
