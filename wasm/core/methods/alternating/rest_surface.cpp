#include "methods/alternating/rest_surface.h"

#include <algorithm>
#include <cmath>

#include "geometry/surface.h"

namespace whittle {

namespace {

constexpr double kDegree = EIGEN_PI / 180;
constexpr double kSimilarityWidth = 30 * kDegree;
constexpr double kSimilarityLimit = 75 * kDegree;
/// The curvature from which on similarity is at full strength.
constexpr double kRound = 0.5;

Index tailOf(const RestSurface& surface, Index halfEdge) {
  return surface.mesh.triangles(faceOf(halfEdge), tailCorner(halfEdge));
}

std::vector<Hinge> hingesOf(const RestSurface& surface) {
  std::vector<Hinge> hinges;
  hinges.reserve(surface.pairs.size());
  for (const FacePair& pair : surface.pairs) {
    const auto opposite = [&](Index halfEdge) {
      return surface.mesh.positions.row(surface.mesh.triangles(faceOf(halfEdge), oppositeCorner(halfEdge)));
    };
    const Vec3 across = (opposite(pair.first) - opposite(pair.second)).transpose();
    hinges.push_back({faceOf(pair.first), faceOf(pair.second),
                      surface.halfEdges.row(pair.first).transpose().stableNormalized(), across.stableNormalized(), 0});
  }
  return hinges;
}

}  // namespace

void halfEdgeVectors(const Points& positions, const Triangles& triangles, Points& vectors) {
  for (Index f = 0; f < triangles.rows(); ++f) {
    for (int i = 0; i < 3; ++i)
      vectors.row(3 * f + i) = positions.row(triangles(f, (i + 1) % 3)) - positions.row(triangles(f, i));
  }
}

RestSurface measureSurface(TriangleMesh mesh) {
  RestSurface surface;
  surface.mesh = std::move(mesh);
  const TriangleMesh& m = surface.mesh;
  surface.edges = MeshEdges(m.triangles, m.vertexCount());
  surface.pairs = facePairs(m.positions, m.triangles, surface.edges);
  surface.halfEdges.resize(surface.halfEdgeCount(), 3);
  halfEdgeVectors(m.positions, m.triangles, surface.halfEdges);
  surface.lengths = surface.halfEdges.rowwise().norm();
  surface.averageLength = surface.lengths.mean();
  surface.faceNormals = faceNormals(m.positions, m.triangles);
  surface.hinges = hingesOf(surface);
  surface.sphericity = Scalars::Zero(surface.faceCount());
  surface.keptDirections = Points::Zero(surface.faceCount(), 3);
  setEdgeNormals(surface, 0);
  setSimilarity(surface);
  return surface;
}

void setEdgeNormals(RestSurface& surface, double meanBelow) {
  surface.edgeNormals.resize(surface.halfEdgeCount(), 3);
  for (Index h = 0; h < surface.halfEdgeCount(); ++h) surface.edgeNormals.row(h) = surface.faceNormals.row(faceOf(h));
  for (const FacePair& pair : surface.pairs) {
    // On a non-manifold edge no two faces go on in one another.
    if (surface.edges.faceCountAt(pair.edge) != 2 || pair.angle >= meanBelow) continue;
    const auto first = surface.faceNormals.row(faceOf(pair.first)),
               second = surface.faceNormals.row(faceOf(pair.second));
    // Of faces that are wound against each other one normal looks the other way; no term minds the sign of the mean.
    const bool isWoundAlike = tailOf(surface, pair.first) != tailOf(surface, pair.second);
    const Vec3 mean = (first + (isWoundAlike ? 1 : -1) * second).transpose().normalized();
    surface.edgeNormals.row(pair.first) = surface.edgeNormals.row(pair.second) = mean.transpose();
  }
}

void setSimilarity(RestSurface& surface) {
  for (std::size_t i = 0; i < surface.pairs.size(); ++i) {
    const double angle = surface.pairs[i].angle;
    surface.hinges[i].similarity =
        angle < kSimilarityLimit ? std::exp(-angle * angle / (2 * kSimilarityWidth * kSimilarityWidth)) : 0;
  }
}

namespace {

double faded(double curvature, double least) { return least + (1 - least) * std::clamp(curvature / kRound, 0.0, 1.0); }

}  // namespace

void fadeSimilarity(RestSurface& surface, const Curvatures& curvatures, double least) {
  for (Hinge& hinge : surface.hinges) {
    hinge.similarity *= faded(std::max(curvatures.strongest(hinge.first), curvatures.strongest(hinge.second)), least);
  }
}

void fadeBorders(RestSurface& surface, const Curvatures& curvatures, double least) {
  for (Hinge& hinge : surface.hinges) {
    const bool keepsFirst = !surface.keptDirections.row(hinge.first).isZero(0);
    const bool keepsSecond = !surface.keptDirections.row(hinge.second).isZero(0);
    if (keepsFirst != keepsSecond)
      hinge.similarity *= faded(curvatures.weakest(keepsFirst ? hinge.second : hinge.first), least);
  }
}

}  // namespace whittle
