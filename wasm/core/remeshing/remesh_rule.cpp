#include "remeshing/remesh_rule.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/feature_edges.h"
#include "geometry/surface.h"
#include "mesh/bounding_box.h"
#include "remeshing/patch_surface.h"

namespace whittle {

namespace {

/// Limits of slippage-preserving reshaping, set on CAD shapes that fail as they are and on remeshed ones that do not.
constexpr double kPoorQuality = 0.1, kPoorArea = 0.02, kUneven = 10, kCoarse = 0.06;

/// Edges on what is flat, as a share of the longest side: finer where it curves.
constexpr double kEdge = 0.04, kCoarser = 1.1;
/// Faces that are expected; what lies between fine and coarse ones adds up to half as many.
constexpr double kMostFaces = 80'000;

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

/// About how many faces come of it: equilateral ones have the area √3/4 edge².
double expectedFaces(const Scalars& areas, const std::vector<double>& sizes) {
  double count = 0;
  for (Index f = 0; f < areas.size(); ++f) count += areas[f] / (std::sqrt(3.0) / 4 * sizes[f] * sizes[f]);
  return count;
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
  const std::vector<FacePair> pairs = facePairs(mesh.positions, mesh.triangles, edges);
  const std::vector<bool> isCrease = featureEdges(pairs, edges.count(), featureAngle * EIGEN_PI / 180);
  const Scalars areas = faceAreas(mesh.positions, mesh.triangles);
  double edge = kEdge * boundingBox(mesh).sizes().maxCoeff();
  while (expectedFaces(areas, edgeSizes(mesh, edges, pairs, isCrease, edge)) > kMostFaces) edge *= kCoarser;
  return edge;
}

}  // namespace whittle
