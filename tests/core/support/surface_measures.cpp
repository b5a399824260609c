#include "support/surface_measures.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "geometry/cotangent.h"
#include "geometry/surface.h"

namespace whittle::testing {

namespace {

/// The faces of every undirected edge.
std::map<std::pair<Index, Index>, std::vector<Index>> facesOfEdges(const Triangles& triangles) {
  std::map<std::pair<Index, Index>, std::vector<Index>> faces;
  for (Index f = 0; f < triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) faces[std::minmax({triangles(f, k), triangles(f, (k + 1) % 3)})].push_back(f);
  }
  return faces;
}

}  // namespace

double volumeInside(const Points& positions, const Triangles& triangles) {
  double sixfold = 0;
  for (Index f = 0; f < triangles.rows(); ++f) {
    const auto at = [&](int k) -> Vec3 { return positions.row(triangles(f, k)).transpose(); };
    sixfold += at(0).dot(at(1).cross(at(2)));
  }
  return sixfold / 6;
}

int bentPairCount(const TriangleMesh& before, const Points& positions) {
  const Points flat = faceNormals(before.positions, before.triangles), bent = faceNormals(positions, before.triangles);
  int count = 0;
  for (const auto& [edge, faces] : facesOfEdges(before.triangles)) {
    if (faces.size() != 2 || flat.row(faces[0]).dot(flat.row(faces[1])) < 0.999) continue;
    count += bent.row(faces[0]).dot(bent.row(faces[1])) < std::cos(25 * EIGEN_PI / 180);
  }
  return count;
}

int foldCount(const Points& positions, const Triangles& triangles) {
  const Points normals = faceNormals(positions, triangles);
  int folds = 0;
  for (const auto& [edge, faces] : facesOfEdges(triangles)) {
    if (faces.size() == 2 && normals.row(faces[0]).dot(normals.row(faces[1])) < -std::sqrt(0.75)) ++folds;
  }
  return folds;
}

double shareWithin(double degrees, const Points& directions, const Points& positions, const Triangles& triangles) {
  const Points normals = faceNormals(positions, triangles);
  const Scalars areas = faceAreas(positions, triangles);
  double inside = 0;
  for (Index f = 0; f < triangles.rows(); ++f) {
    if ((directions * normals.row(f).transpose()).maxCoeff() > std::cos(degrees * EIGEN_PI / 180)) inside += areas[f];
  }
  return inside / areas.sum();
}

Scalars angleDefects(const Points& positions, const Triangles& triangles) {
  Scalars defects = Scalars::Constant(positions.rows(), 2 * EIGEN_PI);
  for (Index f = 0; f < triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const auto to = [&](int corner) -> Vec3 {
        return (positions.row(triangles(f, (k + corner) % 3)) - positions.row(triangles(f, k))).transpose();
      };
      defects[triangles(f, k)] -= std::atan2(to(1).cross(to(2)).norm(), to(1).dot(to(2)));
    }
  }
  for (const auto& [edge, faces] : facesOfEdges(triangles)) {
    if (faces.size() == 1) defects[edge.first] = defects[edge.second] = 0;
  }
  return defects;
}

Eigen::MatrixXd denseLaplacian(const TriangleMesh& mesh) {
  const SparseMatrix lower =
      cotangentLaplacian(mesh.triangles, halfCotangents(mesh.positions, mesh.triangles), mesh.vertexCount());
  return SparseMatrix(lower.selfadjointView<Eigen::Lower>());
}

}  // namespace whittle::testing
