#include "methods/alternating/handle_errors.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "geometry/surface.h"
#include "mesh/adjacency.h"
#include "methods/alternating/vertex_system.h"

namespace whittle {

namespace {

constexpr int kRings = 4;
constexpr double kBent = 10 * EIGEN_PI / 180;
constexpr double kConcentrated = 2;
constexpr double kHeld = 1e5;
constexpr double kTolerance = 1e-5;

/// Grows rings of faces around vertices: the faces of the vertices are ring 1, those that share a vertex with ring k
/// and are in no ring yet are ring k + 1.
class FaceRings {
 public:
  FaceRings(const Triangles& triangles, Index vertexCount)
      : triangles_(triangles), fans_(triangles, vertexCount), ringOf_(triangles.rows(), 0), seen_(vertexCount, false) {}

  void grow(const std::vector<Index>& from, int rings) {
    for (const Index f : faces_) ringOf_[f] = 0;
    for (const Index v : reached_) seen_[v] = false;
    faces_.clear();
    reached_.clear();
    for (const Index v : from) reach(v);
    std::size_t next = 0;
    for (int ring = 1; ring <= rings; ++ring) {
      const std::size_t last = reached_.size(), firstFace = faces_.size();
      for (; next < last; ++next) takeFaces(reached_[next], ring);
      for (std::size_t i = firstFace; i < faces_.size(); ++i) {
        for (int k = 0; k < 3; ++k) reach(triangles_(faces_[i], k));
      }
    }
  }
  const std::vector<Index>& faces() const { return faces_; }
  int ringOf(Index face) const { return ringOf_[face]; }

 private:
  void reach(Index v) {
    if (seen_[v]) return;
    seen_[v] = true;
    reached_.push_back(v);
  }
  void takeFaces(Index v, int ring) {
    for (Index p = fans_.start[v]; p < fans_.start[v + 1]; ++p) {
      const Index f = fans_.corners[p] / 3;
      if (ringOf_[f] > 0) continue;
      ringOf_[f] = ring;
      faces_.push_back(f);
    }
  }

  const Triangles& triangles_;
  Fans fans_;
  std::vector<int> ringOf_;  // #F, 0: none
  std::vector<bool> seen_;   // #V
  std::vector<Index> faces_, reached_;
};

double normalError(const RestSurface& surface, const Points& normals, Index face) {
  return std::acos(std::clamp(surface.faceNormals.row(face).dot(normals.row(face)), -1.0, 1.0));
}

bool isConcentrated(const RestSurface& surface, const Points& normals, Index vertex, FaceRings& rings) {
  rings.grow({vertex}, kRings);
  double atHandle = 0, away = 0;
  for (const Index f : rings.faces()) {
    if (rings.ringOf(f) == 1) atHandle = std::max(atHandle, normalError(surface, normals, f));
    if (rings.ringOf(f) == kRings) away = std::max(away, normalError(surface, normals, f));
  }
  return atHandle > kBent && atHandle > kConcentrated * away;
}

/// The part of a surface around the zone: its faces and the next ring, whose vertices hold it.
struct Patch {
  std::vector<Index> faces;     // of the surface
  std::vector<Index> vertices;  // place → vertex of the surface
  std::vector<Index> placeOf;   // #V, or −1
  RestSurface surface;
};

Patch cutOut(const RestSurface& surface, std::vector<Index> faces) {
  Patch patch{std::move(faces), {}, std::vector<Index>(surface.vertexCount(), -1), {}};
  TriangleMesh mesh{Points(), Triangles(static_cast<Index>(patch.faces.size()), 3)};
  for (Index i = 0; i < mesh.triangles.rows(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const Index v = surface.mesh.triangles(patch.faces[i], k);
      if (patch.placeOf[v] < 0) {
        patch.placeOf[v] = static_cast<Index>(patch.vertices.size());
        patch.vertices.push_back(v);
      }
      mesh.triangles(i, k) = patch.placeOf[v];
    }
  }
  mesh.positions.resize(static_cast<Index>(patch.vertices.size()), 3);
  for (Index p = 0; p < mesh.positions.rows(); ++p)
    mesh.positions.row(p) = surface.mesh.positions.row(patch.vertices[p]);
  patch.surface = measureSurface(std::move(mesh));
  patch.surface.averageLength = surface.averageLength;
  for (Index i = 0; i < patch.surface.faceCount(); ++i) {
    const Index f = patch.faces[i];
    patch.surface.sphericity[i] = surface.sphericity[f];
    patch.surface.edgeNormals.middleRows<3>(3 * i) = surface.edgeNormals.middleRows<3>(3 * f);
  }
  return patch;
}

/// Inside the zone a share of the rest shape's normals, the more the nearer to the handle; outside all is as it is.
EdgeGoals goalsOf(const Patch& patch, const FaceRings& rings, const Points& normals, const Points& present,
                  Transformations& transformations) {
  EdgeGoals goals = restGoals(patch.surface);
  for (Index i = 0; i < patch.surface.faceCount(); ++i) {
    const Index f = patch.faces[i];
    const int ring = rings.ringOf(f);
    const bool isInside = ring >= 1 && ring <= kRings;
    if (!isInside) transformations[i].setIdentity();
    const double share = isInside ? (ring - 1.0) / kRings : 1;
    for (Index h = 3 * i; h < 3 * i + 3; ++h) {
      const Vec3 mixed = (share * normals.row(f) + (1 - share) * goals.normals.row(h)).transpose();
      goals.normals.row(h) = mixed.stableNormalized().transpose();
      if (isInside) continue;
      goals.vectors.row(h) = present.row(h);
      goals.lengths[h] = goals.targetLengths[h] = present.row(h).norm();
    }
  }
  return goals;
}

/// Holds vertices of faces outside the zone where they are, and takes the rows that lie in the patch.
std::vector<PointRow> rowsOf(const Patch& patch, const FaceRings& rings, const std::vector<PointRow>& rows,
                             Index handleCount, double handleStiffness, const RestSurface& surface,
                             const Points& positions) {
  std::vector<PointRow> result;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    PointRow row = rows[r];
    row.halfEdges = {-1, -1};  // lengths stay
    bool isInside = true;
    for (Index& v : std::span(row.vertices).first(row.count)) {
      v = patch.placeOf[v];
      isInside = isInside && v >= 0;
    }
    if (!isInside) continue;
    if (static_cast<Index>(r) < handleCount) row.stiffness = handleStiffness;
    result.push_back(row);
  }
  std::vector<bool> isHeld(patch.vertices.size(), false);
  for (const Index f : patch.faces) {
    if (rings.ringOf(f) <= kRings) continue;
    for (int k = 0; k < 3; ++k) isHeld[patch.placeOf[surface.mesh.triangles(f, k)]] = true;
  }
  for (std::size_t p = 0; p < patch.vertices.size(); ++p) {
    if (!isHeld[p]) continue;
    PointRow row;
    row.stiffness = kHeld;
    row.add(static_cast<Index>(p), 1);
    row.target = positions.row(patch.vertices[p]).transpose();
    result.push_back(row);
  }
  return result;
}

}  // namespace

Status spreadHandleErrors(const RestSurface& surface, const EnergyWeights& weights,
                          const Transformations& transformations, const std::vector<PointRow>& rows, Index handleCount,
                          double handleStiffness, Points& positions, bool& isSpread) {
  isSpread = false;
  const Points normals = faceNormals(positions, surface.mesh.triangles);
  FaceRings rings(surface.mesh.triangles, surface.vertexCount());
  std::vector<Index> bent;
  for (Index r = 0; r < handleCount; ++r) {
    for (int i = 0; i < rows[r].count; ++i) {
      if (isConcentrated(surface, normals, rows[r].vertices[i], rings)) bent.push_back(rows[r].vertices[i]);
    }
  }
  if (bent.empty()) return {};

  rings.grow(bent, kRings + 1);
  const Patch patch = cutOut(surface, rings.faces());
  Transformations ownTransformations;
  Points start(patch.surface.vertexCount(), 3), present(patch.surface.halfEdgeCount(), 3);
  for (const Index f : patch.faces) ownTransformations.push_back(transformations[f]);
  for (Index p = 0; p < start.rows(); ++p) start.row(p) = positions.row(patch.vertices[p]);
  halfEdgeVectors(start, patch.surface.mesh.triangles, present);

  VertexSystem system;
  system.shape(patch.surface, weights, rowsOf(patch, rings, rows, handleCount, handleStiffness, surface, positions));
  const EdgeGoals goals = goalsOf(patch, rings, normals, present, ownTransformations);
  system.assemble(goals, ownTransformations);
  system.beginPrepare();
  for (double share = 0; share < 1;) {
    if (Status status = system.prepareNext(share); !status.ok()) return status;
  }
  if (Status status = system.solve(kTolerance, start); !status.ok()) return status;
  for (Index p = 0; p < start.rows(); ++p) positions.row(patch.vertices[p]) = start.row(p);
  isSpread = true;
  return {};
}

}  // namespace whittle
