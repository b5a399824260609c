#include "methods/alternating/fold_check.h"

#include <algorithm>

#include "geometry/surface.h"

namespace whittle {

namespace {

constexpr double kSteep = 0.5;  // cos 60°

}  // namespace

FoldReport findFolds(const RestSurface& surface, const Points& positions) {
  const Triangles& triangles = surface.mesh.triangles;
  const auto qualityOf = [&](const Points& at, Index f) {
    return triangleQuality(at.row(triangles(f, 0)), at.row(triangles(f, 1)), at.row(triangles(f, 2)));
  };
  const Points normals = faceNormals(positions, triangles);
  FoldReport report;
  std::vector<double> ratios;
  ratios.reserve(surface.faceCount());
  for (Index f = 0; f < surface.faceCount(); ++f) {
    const double cosine = surface.faceNormals.row(f).dot(normals.row(f));
    report.flipped += cosine < 0;
    report.steep += cosine < kSteep;
    const double rest = qualityOf(surface.mesh.positions, f);
    if (rest > 0) ratios.push_back(qualityOf(positions, f) / rest);
  }
  if (ratios.empty()) return report;
  const auto hundredth = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 100);
  std::nth_element(ratios.begin(), hundredth, ratios.end());
  report.poorQuality = *hundredth;
  return report;
}

}  // namespace whittle
