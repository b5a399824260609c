#include "methods/local_global/normal_driven/element_targets.h"

#include "geometry/surface.h"

namespace whittle {

namespace {

/// Means of each face over its corners.
Scalars faceMeans(const Scalars& ofVertices, const Triangles& triangles) {
  Scalars means(triangles.rows());
  for (Index f = 0; f < triangles.rows(); ++f) {
    means[f] = (ofVertices[triangles(f, 0)] + ofVertices[triangles(f, 1)] + ofVertices[triangles(f, 2)]) / 3;
  }
  return means;
}

}  // namespace

void ElementTargets::prepare(const RestShape& rest, Rigidity rigidity, double lambda, const Scalars& ownLambdas) {
  const auto& [positions, triangles] = rest.mesh;
  const bool perFace = rigidity == Rigidity::farap;
  normals_ = perFace ? faceNormals(positions, triangles) : rest.normals;
  strengths_ = perFace ? faceAreas(positions, triangles) : mixedVoronoiAreas(positions, triangles);
  if (ownLambdas.size() == 0) {
    strengths_ *= lambda;
  } else {
    strengths_.array() *= (perFace ? faceMeans(ownLambdas, triangles) : ownLambdas).array();
  }
  normalLanes_.assign(batchCount(count()), {splat(0), splat(0), splat(0)});
  weightedTargets_ = normalLanes_;
  for (Index k = 0; k < count(); ++k) {
    setVector(normalLanes_[k / 4], k % 4, normals_.row(k).transpose());
    if (normals_.row(k).isZero(0)) strengths_[k] = 0;
  }
  energies_ = 2 * strengths_;  // of a target that is not there yet, as of one across
  energy_ = energies_.sum();
}

void ElementTargets::set(Index k, const Vec3& target) {
  setVector(weightedTargets_[k / 4], k % 4, (2 * strengths_[k]) * target);
  const double before = energies_[k];
  energies_[k] = strengths_[k] * (normals_.row(k).transpose() - target).squaredNorm();
  energy_ += energies_[k] - before;
}

void ElementTargets::addTerm(std::size_t batch, MatrixLanes& covariances) const {
  const VectorLanes &n = normalLanes_[batch], &t = weightedTargets_[batch];
  const Lanes rows[] = {n.x, n.y, n.z};
  for (int i = 0; i < 3; ++i) {
    auto& row = covariances.m[i];
    row[0] += rows[i] * t.x, row[1] += rows[i] * t.y, row[2] += rows[i] * t.z;
  }
}

Lanes TargetedLocalStep::fit(std::size_t, const MatrixLanes& covariances, bool, QuaternionLanes& rotations) {
  fitRotations(covariances, rotations);
  return splat(0);
}

}  // namespace whittle
