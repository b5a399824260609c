#include "mesh/validate.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "mesh/adjacency.h"
#include "mesh/bounding_box.h"
#include "mesh/significant_vertices.h"

namespace whittle {

namespace {

/// Above this, the factorization of a surface mesh no longer fits the 4 GB that wasm can address.
constexpr Index kMaxVertices = 2'500'000;

Status checkCounts(const TriangleMesh& mesh) {
  if (mesh.faceCount() == 0) {
    return Status::failure(Code::noFaces, "the mesh has no faces; a point cloud must be meshed first");
  }
  if (mesh.vertexCount() > kMaxVertices) {
    return Status::failure(Code::tooLarge, "the mesh has " + std::to_string(mesh.vertexCount()) +
                                               " vertices, more than the " + std::to_string(kMaxVertices) +
                                               " that fit in memory; decimate it first");
  }
  return {};
}

Status checkIndices(const TriangleMesh& mesh) {
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const Index v = mesh.triangles(f, k);
      if (v >= 0 && v < mesh.vertexCount()) continue;
      return Status::failure(Code::indexOutOfRange,
                             "face {} uses vertex " + std::to_string(v) + ", but there are only " +
                                 std::to_string(mesh.vertexCount()) + "; the file may have been cut off",
                             Element::face(f));
    }
  }
  return {};
}

Status checkPositions(const TriangleMesh& mesh) {
  for (Index corner = 0; corner < mesh.triangles.size(); ++corner) {
    const Index v = mesh.triangles.data()[corner];
    if (mesh.positions.row(v).allFinite()) continue;
    return Status::failure(Code::notFinite, "vertex {} has a coordinate that is not a number; repair or remove it",
                           Element::vertex(v));
  }
  const Vec3 extent = boundingBox(mesh).sizes();
  if (!extent.allFinite() || extent.squaredNorm() > 1e300) {
    return Status::failure(Code::notFinite, "the coordinates are too large to compute with; scale the mesh down");
  }
  if (extent.squaredNorm() < 1e-300) {
    return Status::failure(Code::zeroExtent, "all vertices lie in one point, so there is no shape to work on");
  }
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    if (thickness(mesh, f) > kDegenerateThickness) return {};
  }
  return Status::failure(Code::zeroExtent, "all faces have zero area, so there is no surface to work on");
}

/// Vertices of the part of which the middle one of all used vertices is, parts in order of their size.
Index typicalSize(const Components& parts, Index usedVertices) {
  std::vector<Index> sizes(parts.count, 0);
  for (const Index part : parts.ofVertex) ++sizes[part];
  std::sort(sizes.begin(), sizes.end(), std::greater<>());
  Index seen = 0;
  for (const Index size : sizes) {
    seen += size;
    if (2 * seen >= usedVertices) return size;
  }
  return 0;
}

}  // namespace

Status validate(const TriangleMesh& mesh) {
  for (const auto check : {checkCounts, checkIndices, checkPositions}) {
    Status status = check(mesh);
    if (!status.ok()) return status;
  }
  return {};
}

double thickness(const TriangleMesh& mesh, Index face) {
  const auto corner = [&](int k) -> Vec3 { return mesh.positions.row(mesh.triangles(face, k)).transpose(); };
  const Vec3 a = corner(1) - corner(0);
  const Vec3 b = corner(2) - corner(1);
  const Vec3 c = corner(0) - corner(2);
  const double longest = std::max({a.squaredNorm(), b.squaredNorm(), c.squaredNorm()});
  return longest > 0 ? a.cross(b).norm() / longest : 0;
}

MeshReport inspect(const TriangleMesh& mesh) {
  MeshReport report;
  report.vertices = mesh.vertexCount();
  report.faces = mesh.faceCount();

  std::vector<bool> used(mesh.vertexCount(), false);
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    for (int k = 0; k < 3; ++k) used[mesh.triangles(f, k)] = true;
    report.degenerateFaces += thickness(mesh, f) <= kDegenerateThickness;
  }
  report.isolatedVertices = static_cast<Index>(std::count(used.begin(), used.end(), false));
  const Components parts = connectedComponents(mesh.triangles, mesh.vertexCount());
  report.components = parts.count - report.isolatedVertices;
  report.typicalPart = typicalSize(parts, mesh.vertexCount() - report.isolatedVertices);

  const Fans fans(mesh.triangles, mesh.vertexCount());
  const EdgeCounts edges = countEdges(mesh.triangles, fans);
  report.boundaryEdges = edges.boundary;
  report.nonManifoldEdges = edges.nonManifold;
  report.farVertices =
      mesh.vertexCount() - report.isolatedVertices - static_cast<Index>(significantVertices(mesh).size());
  const Box box = boundingBox(mesh);
  report.min = box.min();
  report.max = box.max();
  return report;
}

}  // namespace whittle
