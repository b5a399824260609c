#include "geometry/feature_edges.h"

#include <algorithm>
#include <cmath>

#include "geometry/surface.h"

namespace whittle {

namespace {

/// Angle between two unit normals, or of one to the other turned round; 0 where one is zero.
double angleBetween(const Vec3& a, const Vec3& b, bool turnedRound) {
  if (a.isZero(0) || b.isZero(0)) return 0;
  return std::atan2(a.cross(b).norm(), turnedRound ? -a.dot(b) : a.dot(b));
}

}  // namespace

std::vector<FacePair> facePairs(const Points& positions, const Triangles& triangles, const MeshEdges& edges) {
  const Points normals = sureNormals(positions, triangles);
  std::vector<FacePair> pairs;
  pairs.reserve(edges.halfEdges.size() / 2);
  for (Index e = 0; e < edges.count(); ++e) {
    for (Index j = edges.start[e] + 1; j < edges.start[e + 1]; ++j) {
      for (Index i = std::max(edges.start[e], j - kMostFacesPaired); i < j; ++i) {
        const Index first = edges.halfEdges[i], second = edges.halfEdges[j];
        const Index f = faceOf(first), g = faceOf(second);
        const bool runSameWay = triangles(f, tailCorner(first)) == triangles(g, tailCorner(second));
        pairs.push_back({e, first, second, angleBetween(normals.row(f), normals.row(g), runSameWay)});
      }
    }
  }
  return pairs;
}

std::vector<bool> featureEdges(const std::vector<FacePair>& pairs, Index edgeCount, double angle) {
  std::vector<bool> features(edgeCount, false);
  for (const FacePair& pair : pairs) {
    if (pair.angle > angle) features[pair.edge] = true;
  }
  return features;
}

}  // namespace whittle
