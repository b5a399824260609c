#include "methods/alternating/reshape_energy.h"

namespace whittle {

Mat3 cornerRotation(const RestSurface& surface, Index face, int corner) {
  const Vec3 to = surface.halfEdges.row(3 * face + corner).transpose();
  const Vec3 from = -surface.halfEdges.row(3 * face + (corner + 2) % 3).transpose();
  const Vec3 n = surface.faceNormals.row(face).transpose();
  const double angle = std::atan2(n.dot(to.cross(from)), to.dot(from));
  return Eigen::AngleAxisd(angle, n).toRotationMatrix();
}

void sphericityFactors(const RestSurface& surface, Index face, int corner, Mat3 factors[3]) {
  const int next = (corner + 1) % 3, last = (corner + 2) % 3;
  factors[last] = Mat3::Identity() / surface.lengths[3 * face + last];
  factors[next] = -cornerRotation(surface, face, corner) / surface.lengths[3 * face + corner];
  factors[corner] = -factors[last] - factors[next];
}

double vertexEnergy(const RestSurface& surface, const EnergyWeights& weights, const EdgeGoals& goals,
                    const Transformations& transformations, const Points& positions) {
  const Triangles& triangles = surface.mesh.triangles;
  double energy = 0, scale = 0;
  for (Index f = 0; f < surface.faceCount(); ++f) {
    const Mat3 inverse = transformations[f].inverse();
    for (int i = 0; i < 3; ++i) {
      const Index h = 3 * f + i;
      const Vec3 e = (positions.row(triangles(f, (i + 1) % 3)) - positions.row(triangles(f, i))).transpose();
      const Vec3 rest = goals.vectors.row(h).transpose();
      const double across = goals.normals.row(h).dot(e.transpose()) / e.norm();
      energy += goals.stress[h] * ((inverse * e - rest).squaredNorm() / (goals.lengths[h] * goals.lengths[h]) +
                                   weights.normal * goals.lengths[h] / surface.averageLength * across * across);
      // An edge counts once, so each of its faces has a share.
      scale += (e - rest).squaredNorm() / surface.edges.faceCountAt(surface.edges.ofHalfEdge[h]);
      if (surface.sphericity[f] > 0) {
        Mat3 factors[3];
        sphericityFactors(surface, f, i, factors);
        Vec3 residual = Vec3::Zero();
        for (int k = 0; k < 3; ++k) residual += factors[k] * positions.row(triangles(f, k)).transpose();
        energy += surface.sphericity[f] * residual.squaredNorm();
      }
    }
  }
  return energy + weights.scale / surface.averageLength * scale;
}

EdgeGoals restGoals(const RestSurface& surface) {
  EdgeGoals goals{surface.halfEdges, surface.lengths, surface.edgeNormals, surface.lengths,
                  Scalars(surface.halfEdgeCount())};
  for (Index h = 0; h < surface.halfEdgeCount(); ++h)
    goals.stress[h] = stressOf(surface.lengths[h], surface.averageLength);
  return goals;
}

double rowEnergy(const std::vector<PointRow>& rows, const Points& positions) {
  double energy = 0;
  for (const PointRow& row : rows) {
    const Vec3 residual = row.residual(positions);
    energy += row.stiffness * residual.dot(row.metric() * residual);
  }
  return energy;
}

}  // namespace whittle
