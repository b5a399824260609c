#include "methods/alternating/alternation.h"

#include <algorithm>
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
  positions_ = best_ = start_ = surface.mesh.positions;
  acceleration_.begin(limits.isAccelerated ? surface.vertexCount() : 0);
  halfEdges_.resize(surface.halfEdgeCount(), 3);
  tau_.assign(surface.faceCount(), Mat3::Identity());
  goals_ = restGoals(surface);
  stage_ = firstStage_ = Stage::assembling;
  next_ = positions_;
  iterations_ = 0;
  moved_.clear();
  moved_.reserve(limits.iterations);
  bestEnergy_ = std::numeric_limits<double>::infinity();
}

void Alternation::resume(const Points& positions) {
  positions_ = start_ = positions;
  stage_ = firstStage_ = Stage::beginning;
}

void Alternation::beginTransformations() {
  halfEdgeVectors(start_, surface_->mesh.triangles, halfEdges_);
  system_->beginSolve(halfEdges_, limits_.transformations, tau_);
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
  report.outcome = Outcome::midway;
  switch (stage_) {
    case Stage::beginning:
      beginTransformations();
      stage_ = Stage::transformations;
      [[fallthrough]];
    case Stage::transformations:
      if (!system_->solveNext()) return {};
      setGoals();
      stage_ = Stage::assembling;
      [[fallthrough]];
    case Stage::assembling:
      vertices_->assemble(goals_, tau_);
      next_ = positions_;
      vertices_->beginSolve(limits_.tolerance, next_);
      stage_ = Stage::vertices;
      [[fallthrough]];
    case Stage::vertices: break;
  }
  bool isSolved = false;
  if (Status status = vertices_->solveNext(isSolved); !status.ok() || !isSolved) return status;
  return this->report(report);
}

Status Alternation::report(StepReport& report) {
  const double energy = vertexEnergy(*surface_, weights_, goals_, tau_, next_) + rowEnergy(vertices_->rows(), next_) +
                        system_->energy(tau_);
  const double move = std::sqrt((next_ - positions_).rowwise().squaredNorm().maxCoeff());
  if (!std::isfinite(energy) || !std::isfinite(move)) {
    return Status::failure(Code::numericalFailure,
                           "the iteration lost its numbers; the mesh may hold faces too thin to compute with");
  }
  const double out = moveOutOfFaces();
  positions_.swap(next_);
  report = {judge(energy, move, out), energy, move};
  if (report.outcome != Outcome::running) return {};
  chooseStart();
  stage_ = firstStage_ = Stage::beginning;
  return {};
}

/// Says where the next iteration starts from.
void Alternation::chooseStart() {
  if (limits_.isAccelerated && iterations_ >= kFirstTested)
    acceleration_.next(positions_, start_);
  else
    start_ = positions_;
}

/// What slides within plane sides is not seen.
double Alternation::moveOutOfFaces() const {
  double largest = 0;
  for (Index f = 0; f < surface_->faceCount(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const Index v = surface_->mesh.triangles(f, k);
      largest = std::max(largest, std::abs(surface_->faceNormals.row(f).dot(next_.row(v) - positions_.row(v))));
    }
  }
  return largest;
}

/// What the last fifth of the iterations moved, three at least.
double Alternation::lateMove() const {
  const std::size_t count = moved_.size(), late = std::max<std::size_t>(3, (count + 4) / 5);
  return moved_.back() - (count > late ? moved_[count - late - 1] : 0);
}

Outcome Alternation::judge(double energy, double move, double moveOutOfFaces) {
  ++iterations_;
  moved_.push_back((moved_.empty() ? 0 : moved_.back()) + move);
  const double decrease = energyBefore_ - energy;
  energyBefore_ = energy;
  if (energy < bestEnergy_) {
    bestEnergy_ = energy;
    best_ = positions_;
  }
  if (iterations_ >= kFirstTested) {
    if (decrease <= 0 && acceleration_.isMixing() && iterations_ < limits_.iterations) {
      acceleration_.forget();
      positions_ = start_ = best_;
      energyBefore_ = bestEnergy_;
      return Outcome::running;
    }
    if (decrease <= 0) {
      positions_ = best_;
      return Outcome::converged;
    }
    if (move < kStillShare * surface_->averageLength) return Outcome::converged;
    if (decrease < kLeastDecrease / std::abs(energy) && lateMove() < limits_.lateMove) return Outcome::converged;
    const double fifth = iterations_ / 5.0;
    if (moveOutOfFaces * fifth < limits_.unseenMove && move * fifth < limits_.unseenSlide) return Outcome::converged;
  }
  return iterations_ >= limits_.iterations ? Outcome::iterationLimit : Outcome::running;
}

}  // namespace whittle
