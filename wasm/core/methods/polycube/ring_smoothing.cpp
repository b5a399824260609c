#include "methods/polycube/ring_smoothing.h"

#include <algorithm>
#include <cstdint>

#include "geometry/surface.h"

namespace whittle {

namespace {

constexpr double kBadQuality = 0.15;

double qualityOf(const Points& positions, const Triangles& triangles, Index f) {
  const auto corner = [&](int k) -> Vec3 { return positions.row(triangles(f, k)).transpose(); };
  return triangleQuality(corner(0), corner(1), corner(2));
}

}  // namespace

void RingSmoothing::prepare(const Points& rest, const Triangles& triangles) {
  acceptable_.resize(triangles.rows());
  for (Index f = 0; f < triangles.rows(); ++f) acceptable_[f] = std::min(kBadQuality, qualityOf(rest, triangles, f));
  // Every face counts the edge that leaves a corner and the one that comes back to it; around an inner vertex they are
  // the same edges.
  neighbours_.assign(rest.rows(), 0);
  std::vector<std::int64_t> openness(rest.rows(), 0);
  for (Index f = 0; f < triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      neighbours_[triangles(f, k)] += 2;
      openness[triangles(f, k)] += triangles(f, (k + 1) % 3) - triangles(f, (k + 2) % 3);
    }
  }
  for (Index v = 0; v < rest.rows(); ++v) {
    if (openness[v] != 0) neighbours_[v] = 0;
  }
  isBad_.assign(rest.rows(), false);
  sums_.resize(rest.rows(), 3);
}

void RingSmoothing::smooth(double share, const Triangles& triangles, Points& positions) {
  std::fill(isBad_.begin(), isBad_.end(), false);
  bool anyBad = false;
  for (Index f = 0; f < triangles.rows(); ++f) {
    if (qualityOf(positions, triangles, f) >= acceptable_[f]) continue;
    anyBad = true;
    for (int k = 0; k < 3; ++k) isBad_[triangles(f, k)] = true;
  }
  if (!anyBad || share == 0) return;
  sums_.setZero();
  for (Index f = 0; f < triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      sums_.row(triangles(f, k)) += positions.row(triangles(f, (k + 1) % 3)) + positions.row(triangles(f, (k + 2) % 3));
    }
  }
  for (Index v = 0; v < positions.rows(); ++v) {
    if (isBad_[v] && neighbours_[v] > 0) positions.row(v) += share * (sums_.row(v) / neighbours_[v] - positions.row(v));
  }
}

}  // namespace whittle
