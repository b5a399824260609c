#include "remeshing/remesh_rule.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "geometry/feature_edges.h"
#include "geometry/surface.h"
#include "mesh/bounding_box.h"
#include "remeshing/patch_surface.h"

namespace whittle {

namespace {

/// Limits of slippage-preserving reshaping, set on CAD shapes that fail as they are and on remeshed ones that do not.
constexpr double kPoorQuality = 0.1, kPoorArea = 0.02, kUneven = 10, kCoarse = 0.06;

constexpr double kFinestEdge = 0.02, kCoarsestEdge = 0.04, kOfRadius = 1.0 / 3;
constexpr double kMostFaces = 120'000;
/// Share of what is round that may be finer than the smallest radius: rounding and odd faces.
constexpr double kOutliers = 0.02;

double edgeLength(const TriangleMesh& mesh, const MeshEdges& edges, Index e) {
  return (mesh.positions.row(edges.ends[e][0]) - mesh.positions.row(edges.ends[e][1])).norm();
}

double medianEdge(const TriangleMesh& mesh, const MeshEdges& edges, double& longest) {
  std::vector<double> lengths(edges.count());
  for (Index e = 0; e < edges.count(); ++e) lengths[e] = edgeLength(mesh, edges, e);
  const auto middle = lengths.begin() + lengths.size() / 2;
  std::nth_element(lengths.begin(), middle, lengths.end());
  longest = *std::max_element(middle, lengths.end());
  return *middle;
}

double poorShare(const TriangleMesh& mesh) {
  const Scalars areas = faceAreas(mesh.positions, mesh.triangles);
  double poor = 0;
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    const auto corner = [&](int k) -> Vec3 { return mesh.positions.row(mesh.triangles(f, k)).transpose(); };
    if (triangleQuality(corner(0), corner(1), corner(2)) < kPoorQuality) poor += areas[f];
  }
  return poor / areas.sum();
}

/// The smallest radius of what is round, but for outliers; infinite where nothing is.
double smallestRadius(const TriangleMesh& mesh, const MeshEdges& edges, double featureAngle) {
  struct Bend {
    double radius, weight;
  };
  std::vector<Bend> bends;
  double total = 0;
  for (const FacePair& pair : facePairs(mesh.positions, mesh.triangles, edges)) {
    if (pair.angle > featureAngle * EIGEN_PI / 180) continue;
    const double radius = bendRadius(mesh, edges, pair);
    if (!std::isfinite(radius)) continue;
    bends.push_back({radius, edgeLength(mesh, edges, pair.edge) * pair.angle});
    total += bends.back().weight;
  }
  std::sort(bends.begin(), bends.end(), [](const Bend& a, const Bend& b) { return a.radius < b.radius; });
  double seen = 0;
  for (const auto& [radius, weight] : bends) {
    if ((seen += weight) > kOutliers * total) return radius;
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace

RemeshCause needsRemeshing(const TriangleMesh& mesh) {
  const MeshEdges edges(mesh.triangles, mesh.vertexCount());
  if (edges.count() == 0) return RemeshCause::none;
  if (poorShare(mesh) > kPoorArea) return RemeshCause::slivers;
  double longest = 0;
  const double median = medianEdge(mesh, edges, longest);
  if (longest > kUneven * median) return RemeshCause::unevenEdges;
  const double side = boundingBox(mesh).sizes().maxCoeff();
  return median > kCoarse * side ? RemeshCause::coarseness : RemeshCause::none;
}

double remeshedEdge(const TriangleMesh& mesh, double featureAngle) {
  const MeshEdges edges(mesh.triangles, mesh.vertexCount());
  const double side = boundingBox(mesh).sizes().maxCoeff();
  const double radius = smallestRadius(mesh, edges, featureAngle);
  const double edge = std::clamp(kOfRadius * radius, kFinestEdge * side, kCoarsestEdge * side);
  // An equilateral face has the area √3/4 edge².
  const double area = faceAreas(mesh.positions, mesh.triangles).sum();
  return std::max(edge, std::sqrt(area / (std::sqrt(3.0) / 4 * kMostFaces)));
}

}  // namespace whittle
