#include "remeshing/patch_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/surface.h"
#include "geometry/triangle_contact.h"
#include "mesh/disjoint_sets.h"

namespace whittle {

namespace {

/// Edges across a curve, as shares of its radius: 14° each, and 29° where that is a small part of what is flat, below
/// kSmall of its edges. Around a hole of a plate edges of a quarter of the radius leave half of the error that edges of a
/// third leave all over, with as many faces.
constexpr double kOfRadius = 0.25, kOfSmallRadius = 0.5, kSmall = 0.375;
/// The finest edges, as a share of those on what is flat.
constexpr double kFinest = 0.1;
/// Bends below this are flat, radians.
constexpr double kFlat = 0.02;
/// Share of the box's longest side within which a patch is a plane.
constexpr double kPlane = 1e-6;

/// Radius by which the surface bends across an edge, from the heights of the two faces over it; infinite where it does
/// not.
double bendRadius(const TriangleMesh& mesh, const MeshEdges& edges, const FacePair& pair) {
  if (pair.angle < kFlat) return std::numeric_limits<double>::infinity();
  const Index a = edges.ends[pair.edge][0], b = edges.ends[pair.edge][1];
  const auto at = [&](Index v) -> Vec3 { return mesh.positions.row(v).transpose(); };
  const Vec3 way = at(b) - at(a);
  const auto height = [&](Index h) {
    const Vec3 side = at(mesh.triangles(faceOf(h), oppositeCorner(h))) - at(a);
    return way.cross(side).norm() / way.norm();
  };
  return (height(pair.first) + height(pair.second)) / 2 / pair.angle;
}

}  // namespace

PatchSurface::PatchSurface(const TriangleMesh& mesh, const MeshEdges& edges, const std::vector<FacePair>& pairs,
                           const std::vector<bool>& isCrease, double edge)
    : mesh_(mesh), normals_(faceNormals(mesh.positions, mesh.triangles)),
      sizes_(edgeSizes(mesh, edges, pairs, isCrease, edge)) {
  joinPatches(pairs, isCrease);
  findPlanes();
  std::vector<Box> boxes(mesh.faceCount());
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    for (int k = 0; k < 3; ++k) boxes[f].extend(corner(f, k));
  }
  tree_.emplace(std::move(boxes));
}

void PatchSurface::joinPatches(const std::vector<FacePair>& pairs, const std::vector<bool>& isCrease) {
  DisjointSets sets(mesh_.faceCount());
  for (const FacePair& pair : pairs) {
    if (!isCrease[pair.edge]) sets.join(faceOf(pair.first), faceOf(pair.second));
  }
  patchOf_.resize(mesh_.faceCount());
  Index count = 0;
  for (Index f = 0; f < mesh_.faceCount(); ++f) {
    const Index root = sets.find(f);
    patchOf_[f] = root == f ? count++ : patchOf_[root];
  }
  planes_.resize(count);
}

void PatchSurface::findPlanes() {
  const Scalars areas = faceAreas(mesh_.positions, mesh_.triangles);
  Scalars total = Scalars::Zero(planes_.size());
  for (Index f = 0; f < mesh_.faceCount(); ++f) {
    Plane& plane = planes_[patchOf_[f]];
    plane.normal += areas[f] * normals_.row(f).transpose();
    total[patchOf_[f]] += areas[f];
    plane.point = corner(f, 0);
  }
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    // Folded onto itself it would be flat and yet no plane.
    planes_[i].isFlat = planes_[i].normal.norm() > 0.999 * total[i];
    planes_[i].normal.normalize();
  }
  const double most = kPlane * boundingBox(mesh_).sizes().maxCoeff();
  for (Index f = 0; f < mesh_.faceCount(); ++f) {
    Plane& plane = planes_[patchOf_[f]];
    for (int k = 0; k < 3; ++k) {
      if (std::abs(plane.normal.dot(corner(f, k) - plane.point)) > most) plane.isFlat = false;
    }
  }
}

std::vector<double> edgeSizes(const TriangleMesh& mesh, const MeshEdges& edges, const std::vector<FacePair>& pairs,
                              const std::vector<bool>& isCrease, double edge) {
  std::vector<double> sizes(mesh.faceCount(), edge);
  for (const FacePair& pair : pairs) {
    if (isCrease[pair.edge]) continue;
    const double radius = bendRadius(mesh, edges, pair);
    const double size =
        std::max({kFinest * edge, kOfRadius * radius, std::min(kSmall * edge, kOfSmallRadius * radius)});
    for (const Index h : {pair.first, pair.second}) sizes[faceOf(h)] = std::min(sizes[faceOf(h)], size);
  }
  return sizes;
}

PatchSurface::Foot PatchSurface::project(const Vec3& point, const Vec3& normal, Index near) const {
  const Plane& plane = planes_[patchOf_[near]];
  if (plane.isFlat) return {near, point - plane.normal.dot(point - plane.point) * plane.normal};
  const auto footOn = [&](Index face) -> Vec3 {
    const Vec3 a = corner(face, 0), b = corner(face, 1), c = corner(face, 2), weights = nearestPoint(point, a, b, c);
    return weights[0] * a + weights[1] * b + weights[2] * c;
  };
  Foot foot{near, footOn(near)};
  double least = (foot.point - point).squaredNorm();
  if (normals_.row(near).dot(normal) < 0) least = std::numeric_limits<double>::infinity();
  tree_->findNear(point, least, [&](Index face) {
    if (patchOf_[face] != patchOf_[near] || normals_.row(face).dot(normal) < 0) return least;
    const Vec3 other = footOn(face);
    const double distance = (other - point).squaredNorm();
    if (distance < least) {
      least = distance;
      foot = {face, other};
    }
    return least;
  });
  return foot;
}

}  // namespace whittle
