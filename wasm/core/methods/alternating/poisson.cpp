#include "methods/alternating/poisson.h"

#include <cmath>

namespace whittle {

namespace {

constexpr double kTolerance = 1e-5;

}  // namespace

void PoissonRun::shape(const RestSurface& surface, std::vector<PointRow> rows) {
  surface_ = &surface;
  system_.shape(surface, {}, std::move(rows));
  system_.assemblePoisson();
  system_.beginPrepare();
}

void PoissonRun::aim(const std::vector<Vec3>& targets) {
  for (std::size_t h = 0; h < targets.size(); ++h) system_.rows()[h].target = targets[h];
}

Status PoissonRun::step(StepReport& report) {
  positions_ = surface_->mesh.positions;
  system_.assemblePoisson();
  for (double share = system_.beginRun() ? 1 : 0; share < 1;) {
    if (Status status = system_.prepareNext(share); !status.ok()) return status;
  }
  if (Status status = system_.solve(kTolerance, positions_); !status.ok()) return status;
  report.energy = rowEnergy(system_.rows(), positions_);
  for (Index h = 0; h < surface_->halfEdgeCount(); ++h) {
    const Triangles& triangles = surface_->mesh.triangles;
    const auto e =
        positions_.row(triangles(faceOf(h), headCorner(h))) - positions_.row(triangles(faceOf(h), tailCorner(h)));
    report.energy += (e - surface_->halfEdges.row(h)).squaredNorm() / surface_->averageLength;
  }
  report.change = std::sqrt((positions_ - surface_->mesh.positions).rowwise().squaredNorm().maxCoeff());
  report.outcome = Outcome::converged;
  return {};
}

}  // namespace whittle
