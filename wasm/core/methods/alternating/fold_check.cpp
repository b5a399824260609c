#include "methods/alternating/fold_check.h"

#include <algorithm>

#include "geometry/surface.h"

namespace whittle {

namespace {

constexpr double kSteep = 0.5;     // cos 60°
constexpr double kInPlane = 0.97;  // cos 14°, which what is flat is bent by at most

}  // namespace

FoldReport findFolds(const RestSurface& surface, const Points& positions) {
  const Triangles& triangles = surface.mesh.triangles;
  const auto qualityOf = [&](const Points& at, Index f) {
    return triangleQuality(at.row(triangles(f, 0)), at.row(triangles(f, 1)), at.row(triangles(f, 2)));
  };
  const Points normals = faceNormals(positions, triangles);
  FoldReport report;
  double area = 0;
  std::vector<double> ratios;
  ratios.reserve(surface.faceCount());
  for (Index f = 0; f < surface.faceCount(); ++f) {
    const double cosine = surface.faceNormals.row(f).dot(normals.row(f));
    report.flipped += cosine < 0;
    report.steep += cosine < kSteep;
    const double size = surface.halfEdges.row(3 * f).cross(surface.halfEdges.row(3 * f + 1)).norm();
    area += size;
    if (cosine < kSteep) report.steepArea += size;
    const double rest = qualityOf(surface.mesh.positions, f);
    if (rest > 0) ratios.push_back(qualityOf(positions, f) / rest);
  }
  if (area > 0) report.steepArea /= area;
  if (ratios.empty()) return report;
  const auto hundredth = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 100);
  std::nth_element(ratios.begin(), hundredth, ratios.end());
  report.poorQuality = *hundredth;
  return report;
}

Index turnedInPlane(const TriangleMesh& input, const Points& positions, const CarriedBack& from) {
  const Triangles& triangles = from.surface.mesh.triangles;
  const Points workingNormals = faceNormals(from.positions, triangles);
  std::vector<bool> isFolded(from.surface.vertexCount(), false);
  for (Index f = 0; f < from.surface.faceCount(); ++f) {
    if (from.surface.faceNormals.row(f).dot(workingNormals.row(f)) >= 0) continue;
    for (int k = 0; k < 3; ++k) isFolded[triangles(f, k)] = true;
  }
  const auto followsFold = [&](Index vertex) {
    const Transfer::Place& place = from.transfer.place(vertex);
    if (place.twin >= 0) return static_cast<bool>(isFolded[place.twin]);
    bool found = false;
    for (int k = 0; k < 3 && place.face >= 0; ++k) found = found || isFolded[triangles(place.face, k)];
    return found;
  };
  const Points before = faceNormals(input.positions, input.triangles), after = faceNormals(positions, input.triangles);
  Index count = 0;
  for (Index f = 0; f < input.faceCount(); ++f) {
    if (before.row(f).dot(after.row(f)) > -kInPlane) continue;
    bool isSaid = false;
    for (int k = 0; k < 3; ++k) isSaid = isSaid || followsFold(input.triangles(f, k));
    count += !isSaid;
  }
  return count;
}

}  // namespace whittle
