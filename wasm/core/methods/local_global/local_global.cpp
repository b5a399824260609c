#include "methods/local_global/local_global.h"

#include <algorithm>
#include <cmath>

#include "geometry/surface.h"

namespace whittle {

namespace {

/// A step shorter than this (unit frame) is rounding: the shape is at rest.
constexpr double kNoMove = 1e-13;

}  // namespace

std::vector<ParameterInfo> withSharedParameters(std::vector<ParameterInfo> own) {
  own.push_back({"handles", ParameterKind::handles, Stale::system});
  own.push_back({"tolerance", ParameterKind::number, Stale::targets, 3e-3, 0, 1});
  own.push_back({"maxIterations", ParameterKind::integer, Stale::targets, 1000, 0, 1e6});
  return own;
}

Status LocalGlobal::prepare(const TriangleMesh& rest, const Settings& settings, Stale stale) {
  if (stale == Stale::nothing) return {};
  stopping_.tolerance = settings.numbers[ownParameters_ + 1];
  stopping_.maxIterations = static_cast<int>(settings.numbers[ownParameters_ + 2]);
  handles_.targets = settings.handles.targets;
  if (stale >= Stale::all) prepareRestShape(rest);
  if (stale >= Stale::weights) localStep_->prepare(*rest_, settings);
  return stale >= Stale::system ? prepareSystem(settings.handles) : Status{};
}

void LocalGlobal::prepareRestShape(const TriangleMesh& rest) {
  rest_.emplace(RestShape{rest, barycentricAreas(rest.positions, rest.triangles), vertexNormals(rest.positions, rest.triangles)});
  edges_.emplace(localStep_->edgeSet(), rest);
  components_ = connectedComponents(rest.triangles, rest.vertexCount());

  rotations_.assign(edges_->elementCount(), Mat3::Identity());
  covariances_.assign(edges_->elementCount(), Mat3::Zero());
  residual_.resize(rest.vertexCount(), 3);
  previous_.resize(rest.vertexCount(), 3);
}

Status LocalGlobal::prepareSystem(const Handles& handles) {
  handles_ = handles;
  gauge_.emplace(components_, handles.vertices, rest_->mesh.positions, rest_->areas);
  std::vector<Index> held = handles.vertices;
  held.insert(held.end(), gauge_->pins().begin(), gauge_->pins().end());
  const TriangleMesh& mesh = rest_->mesh;
  return system_.prepare(cotangentLaplacian(mesh.triangles, edges_->halfCotangents(), mesh.vertexCount()), held);
}

void LocalGlobal::begin(Points& positions) {
  stopping_.begin();
  localStep_->begin();
  std::fill(rotations_.begin(), rotations_.end(), Mat3::Identity());
  applyHandles(handles_, positions);
}

Status LocalGlobal::step(Points& positions, StepReport& report) {
  if (stopping_.exhausted()) {
    report = {Outcome::iterationLimit, 0, 0};
    return {};
  }
  previous_ = positions;
  report.energy = edges_->gatherCovariances(positions, covariances_);
  report.energy += localStep_->fit(covariances_, rotations_);
  globalStep(positions);
  report.change = relativeDisplacement(positions);
  if (!std::isfinite(report.energy) || !std::isfinite(report.change)) {
    positions = previous_;
    return Status::failure(Code::numericalFailure,
                           "the iteration lost its numbers; the mesh may hold faces too thin to compute with");
  }
  report.outcome = stopping_.judge(report);
  return {};
}

void LocalGlobal::globalStep(Points& positions) {
  edges_->scatterResidual(rotations_, positions, residual_);
  system_.correct(residual_, positions);
  gauge_->restoreCentroids(positions);
}

double LocalGlobal::relativeDisplacement(const Points& positions) const {
  const double move = std::sqrt((positions - previous_).rowwise().squaredNorm().maxCoeff());
  const double way = std::sqrt((positions - rest_->mesh.positions).rowwise().squaredNorm().maxCoeff());
  return move <= kNoMove ? 0 : move / way;
}

}  // namespace whittle
