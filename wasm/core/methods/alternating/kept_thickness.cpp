#include "methods/alternating/kept_thickness.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace whittle {

namespace {

constexpr double kSeen = 0.1;
/// What lies farther out, of the changed area, is an outlier.
constexpr double kOutliers = 0.05;

Vec3 corner(const Points& positions, const RestSurface& surface, Index face, int k) {
  return positions.row(surface.mesh.triangles(face, k)).transpose();
}

/// Along the normal of the face.
double thickness(const RestSurface& surface, const ThicknessProbe& probe, const Points& positions) {
  const Vec3 a = corner(positions, surface, probe.face, 0), b = corner(positions, surface, probe.face, 1),
             c = corner(positions, surface, probe.face, 2);
  Vec3 behind = Vec3::Zero();
  for (int k = 0; k < 3; ++k) behind += probe.weights[k] * corner(positions, surface, probe.behind, k);
  return ((a + b + c) / 3 - behind).dot((b - a).cross(c - a).stableNormalized());
}

/// The moves that handles ask of vertices, #V×3, and whether there are any.
struct AskedMoves {
  std::vector<bool> areAsked;
  Points moves;

  AskedMoves(const RestSurface& surface, const std::vector<PointRow>& handles)
      : areAsked(surface.vertexCount(), false), moves(Points::Zero(surface.vertexCount(), 3)) {
    for (const PointRow& handle : handles) {
      const Vec3 move = -handle.residual(surface.mesh.positions);
      for (int i = 0; i < handle.count; ++i) {
        areAsked[handle.vertices[i]] = true;
        moves.row(handle.vertices[i]) = move.transpose();
      }
    }
  }

  /// The mean of what is asked of a face's corners along a direction; false if nothing is.
  bool ofFace(const RestSurface& surface, Index face, const Vec3& direction, double& mean) const {
    double sum = 0;
    int count = 0;
    for (int k = 0; k < 3; ++k) {
      const Index v = surface.mesh.triangles(face, k);
      if (!areAsked[v]) continue;
      sum += moves.row(v).dot(direction);
      ++count;
    }
    mean = count > 0 ? sum / count : 0;
    return count > 0;
  }
};

}  // namespace

ThicknessReport findChangedThickness(const RestSurface& surface, const std::vector<ThicknessProbe>& probes,
                                     const std::vector<PointRow>& handles, const Points& positions) {
  const AskedMoves asked(surface, handles);
  std::vector<std::pair<double, double>> changed;  // ratio's logarithm, area
  double all = 0, changedArea = 0;
  for (const ThicknessProbe& probe : probes) {
    const Vec3 n = surface.faceNormals.row(probe.face).transpose();
    double here = 0, behind = 0;
    const bool isHeld = asked.ofFace(surface, probe.face, n, here) && asked.ofFace(surface, probe.behind, n, behind);
    if (isHeld && std::abs(here - behind) > kMovedApart) continue;
    const double before = thickness(surface, probe, surface.mesh.positions);
    const double after = thickness(surface, probe, positions);
    if (!(before > 0)) continue;
    const double area = surface.halfEdges.row(3 * probe.face).cross(surface.halfEdges.row(3 * probe.face + 1)).norm();
    all += area;
    if (std::abs(after / before - 1) < kSeen) continue;
    changed.push_back({std::log(std::max(after / before, 1e-3)), area});
    changedArea += area;
  }
  ThicknessReport report;
  if (changed.empty()) return report;
  report.changedArea = changedArea / all;
  std::sort(changed.begin(), changed.end(),
            [](const auto& a, const auto& b) { return std::abs(a.first) > std::abs(b.first); });
  double passed = 0;
  for (const auto& [logarithm, area] : changed) {
    passed += area;
    if (passed < kOutliers * changedArea) continue;
    report.most = std::exp(logarithm);
    break;
  }
  return report;
}

}  // namespace whittle
