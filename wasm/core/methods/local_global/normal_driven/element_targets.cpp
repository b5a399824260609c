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
  elementCount_ = count();
  layout_ = FanLayout::ofSingles(count());
  takeNormals();
}

void ElementTargets::prepareFans(const RestShape& rest, double lambda, const Scalars& ownLambdas) {
  const auto& [positions, triangles] = rest.mesh;
  const SmoothFans& fans = rest.fans;
  normals_ = fanNormals(positions, triangles, fans);
  strengths_ = mixedVoronoiAreas(positions, triangles, fans);
  elementCount_ = rest.mesh.vertexCount();
  for (Index v = 0; v < elementCount_; ++v) {
    const double own = ownLambdas.size() == 0 ? lambda : ownLambdas[v];
    for (Index fan = fans.start[v]; fan < fans.start[v + 1]; ++fan) strengths_[fan] *= own;
  }
  layout_ = FanLayout(fans);
  takeNormals();
}

void ElementTargets::takeNormals() {
  const VectorLanes none{splat(0), splat(0), splat(0)};
  slots_.assign(layout_.slotCount(), {none, none});
  for (Index k = 0; k < count(); ++k) {
    const Index lane = layout_.lanes[k];
    setVector(slots_[lane / 4].normal, lane % 4, normals_.row(k).transpose());
    if (normals_.row(k).isZero(0)) strengths_[k] = 0;
  }
  forgetTargets();
}

void ElementTargets::forgetTargets() {
  energies_ = 2 * strengths_;  // of a target that is not there yet, as of one across
  energy_ = energies_.sum();
}

void ElementTargets::weaken(const SphereField& field) {
  for (Index k = 0; k < count(); ++k) {
    if (strengths_[k] != 0) strengths_[k] *= field(normals_.row(k).transpose());
  }
  forgetTargets();
}

Scalars ElementTargets::elementStrengths() const {
  Scalars sums = Scalars::Zero(elementCount_);
  std::size_t batch = 0;
  for (Index k = 0; k < count(); ++k) {
    while (layout_.lanes[k] / 4 >= layout_.start[batch + 1]) ++batch;
    sums[4 * static_cast<Index>(batch) + layout_.lanes[k] % 4] += strengths_[k];
  }
  return sums;
}

void ElementTargets::set(Index k, const Vec3& target) {
  const Index lane = layout_.lanes[k];
  setVector(slots_[lane / 4].weightedTarget, lane % 4, (2 * strengths_[k]) * target);
  const double before = energies_[k];
  energies_[k] = strengths_[k] * (normals_.row(k).transpose() - target).squaredNorm();
  energy_ += energies_[k] - before;
}

void ElementTargets::addTerm(std::size_t batch, MatrixLanes& covariances) const {
  for (Index slot = layout_.start[batch]; slot < layout_.start[batch + 1]; ++slot)
    addOuter(covariances, slots_[slot].normal, slots_[slot].weightedTarget);
}

Lanes TargetedLocalStep::fit(std::size_t, const MatrixLanes& covariances, bool, QuaternionLanes& rotations) {
  fitRotations(covariances, rotations);
  return splat(0);
}

}  // namespace whittle
