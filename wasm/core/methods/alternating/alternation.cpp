#include "methods/alternating/alternation.h"

#include <cmath>
#include <limits>

namespace whittle {

namespace {

/// The first solves have yet to find their way: the tests begin with the third.
constexpr int kFirstTested = 3;
constexpr double kStillShare = 0.01;     // of the mean edge
constexpr double kLeastDecrease = 0.01;  // times 1 / |E|

}  // namespace

void Alternation::begin(const RestSurface& surface, const EnergyWeights& weights, VertexSystem& vertices,
                        TransformationSystem& transformations, const AlternationLimits& limits) {
  surface_ = &surface;
  weights_ = weights;
  vertices_ = &vertices;
  system_ = &transformations;
  limits_ = limits;
  positions_ = previous_ = best_ = surface.mesh.positions;
  halfEdges_.resize(surface.halfEdgeCount(), 3);
  tau_.assign(surface.faceCount(), Mat3::Identity());
  goals_ = restGoals(surface);
  iterations_ = 0;
  bestEnergy_ = std::numeric_limits<double>::infinity();
}

void Alternation::resume(const Points& positions) {
  positions_ = positions;
  halfEdgeVectors(positions_, surface_->mesh.triangles, halfEdges_);
  system_->solve(halfEdges_, limits_.transformations, tau_);
  setGoals();
}

void Alternation::setGoals() {
  const MeshEdges& edges = surface_->edges;
  for (Index e = 0; e < edges.count(); ++e) {
    double sum = 0;
    for (Index place = edges.start[e]; place < edges.start[e + 1]; ++place) {
      const Index h = edges.halfEdges[place];
      sum += (tau_[faceOf(h)] * surface_->halfEdges.row(h).transpose()).norm();
    }
    const double length = sum / edges.faceCountAt(e);
    for (Index place = edges.start[e]; place < edges.start[e + 1]; ++place) {
      const Index h = edges.halfEdges[place];
      goals_.targetLengths[h] = length;
      goals_.stress[h] = stressOf(halfEdges_.row(h).norm(), surface_->averageLength);
    }
  }
}

Status Alternation::iterate(StepReport& report) {
  vertices_->assemble(goals_, tau_);
  previous_ = positions_;
  if (Status status = vertices_->solve(limits_.tolerance, positions_); !status.ok()) {
    positions_ = previous_;
    return status;
  }
  const double energy = vertexEnergy(*surface_, weights_, goals_, tau_, positions_) +
                        rowEnergy(vertices_->rows(), positions_) + system_->energy(tau_);
  const double move = std::sqrt((positions_ - previous_).rowwise().squaredNorm().maxCoeff());
  if (!std::isfinite(energy) || !std::isfinite(move)) {
    positions_ = previous_;
    return Status::failure(Code::numericalFailure,
                           "the iteration lost its numbers; the mesh may hold faces too thin to compute with");
  }
  report.energy = energy;
  report.change = move;
  report.outcome = judge(energy, move);
  if (report.outcome != Outcome::running) return {};
  halfEdgeVectors(positions_, surface_->mesh.triangles, halfEdges_);
  system_->solve(halfEdges_, limits_.transformations, tau_);
  setGoals();
  return {};
}

Outcome Alternation::judge(double energy, double move) {
  ++iterations_;
  const double decrease = energyBefore_ - energy;
  energyBefore_ = energy;
  if (energy < bestEnergy_) {
    bestEnergy_ = energy;
    best_ = positions_;
  }
  if (iterations_ >= kFirstTested) {
    if (decrease <= 0) {
      positions_ = best_;
      return Outcome::converged;
    }
    if (move < kStillShare * surface_->averageLength) return Outcome::converged;
    if (decrease < kLeastDecrease / std::abs(energy)) return Outcome::converged;
    if (move * iterations_ / 5 < limits_.unseenMove) return Outcome::converged;
  }
  return iterations_ >= limits_.iterations ? Outcome::iterationLimit : Outcome::running;
}

}  // namespace whittle
