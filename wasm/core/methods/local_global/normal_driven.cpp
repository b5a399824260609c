#include "methods/local_global/normal_driven.h"

#include "geometry/rotation_fit.h"
#include "geometry/surface.h"
#include "methods/local_global/local_global.h"

namespace whittle {

namespace {

enum Parameter { kStyle, kLambda, kRegularizer, kDynamicTargets, kLambdaPerVertex, kOwnParameters };

/// λ of every element: its own, the mean of a face's corners, or the one of all.
Scalars lambdas(const Settings& settings, const Triangles& triangles, Index vertexCount, bool perFace) {
  const Scalars& own = settings.scalars[kLambdaPerVertex];
  if (own.size() == 0) return Scalars::Constant(perFace ? triangles.rows() : vertexCount, settings.numbers[kLambda]);
  if (!perFace) return own;
  Scalars means(triangles.rows());
  for (Index f = 0; f < triangles.rows(); ++f) {
    means[f] = (own[triangles(f, 0)] + own[triangles(f, 1)] + own[triangles(f, 2)]) / 3;
  }
  return means;
}

}  // namespace

Rigidity NormalDriven::rigidity(const Settings& settings) const { return static_cast<Rigidity>(settings.numbers[kRegularizer]); }

Status NormalDriven::prepare(const RestShape& rest, const Settings& settings) {
  if (!settings.style) {
    return Status::failure(Code::badParameter, "an analogy needs a style; choose one, for example the cube");
  }
  style_ = settings.style;
  triangles_ = &rest.mesh.triangles;
  rigidity_ = rigidity(settings);
  isDynamic_ = settings.numbers[kDynamicTargets] != 0;
  prepareStrengths(rest, settings);
  lookUpTargets();
  return {};
}

void NormalDriven::prepareStrengths(const RestShape& rest, const Settings& settings) {
  const auto& [positions, triangles] = rest.mesh;
  const bool perFace = rigidity_ == Rigidity::farap;
  present_ = perFace ? faceNormals(positions, triangles) : rest.normals;
  scratch_.resize(positions.rows());
  const Scalars areas = perFace ? faceAreas(positions, triangles) : mixedVoronoiAreas(positions, triangles);
  strengths_ = areas.cwiseProduct(lambdas(settings, triangles, rest.mesh.vertexCount(), perFace));
  const Index count = static_cast<Index>(present_.rows());
  normals_.assign(batchCount(count), WideVectors{});
  pulls_ = normals_;
  for (Index k = 0; k < count; ++k) {
    WideVectors& n = normals_[k / 4];
    n.x[k % 4] = present_(k, 0), n.y[k % 4] = present_(k, 1), n.z[k % 4] = present_(k, 2);
    if (present_.row(k).isZero(0)) strengths_[k] = 0;
  }
  pullEnergy_ = 2 * strengths_.sum();
}

void NormalDriven::observe(const Points& positions) {
  if (!isDynamic_) return;
  if (rigidity_ == Rigidity::farap) {
    faceNormals(positions, *triangles_, present_);
  } else {
    vertexNormals(positions, *triangles_, present_, scratch_);
  }
  lookUpTargets();
}

void NormalDriven::lookUpTargets() {
  for (Index k = 0; k < strengths_.size(); ++k) {
    const Vec3 n = present_.row(k).transpose();
    if (strengths_[k] == 0 || n.isZero(0)) continue;
    const Vec3 target = (2 * strengths_[k]) * (*style_)(n);
    WideVectors& pull = pulls_[k / 4];
    pull.x[k % 4] = target.x(), pull.y[k % 4] = target.y(), pull.z[k % 4] = target.z();
  }
}

void NormalDriven::pull(std::size_t batch, CovarianceLanes& covariances) const {
  const WideVectors &n = normals_[batch], &t = pulls_[batch];
  const DoubleLanes rows[] = {n.x, n.y, n.z};
  for (int i = 0; i < 3; ++i) {
    auto& row = covariances.m[i];
    row[0] += rows[i] * t.x, row[1] += rows[i] * t.y, row[2] += rows[i] * t.z;
  }
}

Lanes NormalDriven::fit(std::size_t, const ScaledCovariances& covariances, bool, QuaternionLanes& rotations) {
  fitRotations(covariances, rotations);
  return splat(0);
}

MethodInfo analogyMethod() {
  const auto create = []() -> std::unique_ptr<Method> {
    return std::make_unique<LocalGlobal>(std::make_unique<NormalDriven>(), kOwnParameters);
  };
  return {"analogy",
          withSharedParameters({{"style", ParameterKind::style, Stale::weights},
                                {"lambda", ParameterKind::number, Stale::weights, 1, 0, 100},
                                rigidityParameter(),
                                flagParameter("dynamicTargets", Stale::weights),
                                {"lambdaPerVertex", ParameterKind::scalars, Stale::weights, 0, 0, 100}}),
          create};
}

}  // namespace whittle
