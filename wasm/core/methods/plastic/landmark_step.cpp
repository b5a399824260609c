#include "methods/plastic/landmark_step.h"

#include <algorithm>

#include "optimization/dual_gauss_newton.h"

namespace whittle {

namespace {

constexpr Index kBatch = ConjugateGradients::kBatch;

}  // namespace

Vec3 Landmark::at(const Points& positions) const {
  Vec3 place = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    if (vertices[i] >= 0) place += weights[i] * positions.row(vertices[i]).transpose();
  }
  return place;
}

void LandmarkStep::begin(const Problem& problem, ShellSystem& system, PlasticPrior& prior) {
  problem_.emplace(problem);
  system_ = &system;
  prior_ = &prior;
  stage_ = Stage::compliance;
  next_ = 0;
  compliance_.setZero(3 * problem.shell.vertexCount(), 3 * static_cast<Index>(problem.landmarks.size()));
}

Status LandmarkStep::next(bool& isDone) {
  Status status;
  switch (stage_) {
    case Stage::compliance: {
      const Index count = std::min<Index>(kBatch, static_cast<Index>(compliance_.cols()) - next_);
      setLoads(next_, count);
      status = system_->solve(batch_);
      takeSolutions(next_);
      next_ += count;
      if (next_ == compliance_.cols()) stage_ = Stage::sensitivities;
      break;
    }
    case Stage::sensitivities:
      findSensitivities();
      prior_->beginSolve(kept_);
      stage_ = Stage::prior;
      break;
    case Stage::prior: {
      bool isSolved = false;
      status = prior_->solveNext(isSolved);
      if (isSolved) stage_ = Stage::dual;
      break;
    }
    case Stage::dual:
      status = solveForField();
      stage_ = Stage::predictor;
      break;
    case Stage::predictor:
      status = predict();
      stage_ = Stage::done;
      break;
    case Stage::done: break;
  }
  isDone = stage_ == Stage::done;
  return status;
}

/// Unit forces along x, y and z at the landmarks.
void LandmarkStep::setLoads(Index first, Index count) {
  batch_.setZero(system_->unknowns(), count);
  for (Index column = 0; column < count; ++column) {
    const Landmark& landmark = problem_->landmarks[(first + column) / 3];
    for (int i = 0; i < 3; ++i) {
      const Index node = landmark.vertices[i] < 0 ? -1 : system_->nodeOf()[landmark.vertices[i]];
      if (node >= 0) batch_(3 * node + (first + column) % 3, column) += landmark.weights[i];
    }
  }
}

void LandmarkStep::takeSolutions(Index first) {
  const std::vector<Index>& nodeOf = system_->nodeOf();
  for (std::size_t v = 0; v < nodeOf.size(); ++v) {
    if (nodeOf[v] < 0) continue;
    compliance_.block(3 * static_cast<Index>(v), first, 3, batch_.cols()) = batch_.middleRows(3 * nodeOf[v], 3);
  }
}

void LandmarkStep::findSensitivities() {
  sensitivity_.take(problem_->shell);
  sensitivity_.applyTransposed(compliance_, transposed_);
  transposed_ *= -1;
  kept_ = transposed_;
}

Status LandmarkStep::solveForField() {
  const Index landmarks = static_cast<Index>(problem_->landmarks.size());
  const Shell& shell = problem_->shell;
  forces_.resize(shell.vertexCount(), 3);
  shell.energy(forces_);
  // What the shape is off its equilibrium moves the landmarks as well.
  Scalars target = transposed_.transpose() * problem_->field;
  target += compliance_.transpose() * Eigen::Map<const Scalars>(forces_.data(), forces_.size());
  Eigen::MatrixXd G(3 * landmarks, problem_->modes.count() + prior_->growth().cols());
  for (Index l = 0; l < landmarks; ++l) {
    const Landmark& landmark = problem_->landmarks[l];
    target.segment<3>(3 * l) += landmark.target - landmark.at(shell.input().positions);
    G.middleRows(3 * l, 3).setZero();
    for (int i = 0; i < 3; ++i) {
      if (landmark.vertices[i] < 0) continue;
      G.block(3 * l, 0, 3, problem_->modes.count()) +=
          landmark.weights[i] * problem_->modes.velocities(landmark.vertices[i]);
    }
  }
  G.rightCols(prior_->growth().cols()) = transposed_.transpose() * prior_->growth();
  DualStep step;
  if (Status status = solveDual(transposed_.transpose() * kept_, target, G, step); !status.ok()) return status;
  const Scalars field = kept_ * step.multipliers + prior_->growth() * step.free.tail(prior_->growth().cols());
  change_ = field - problem_->field;
  rigid_ = step.free.head(problem_->modes.count());
  model_ = step.multipliers.squaredNorm() + prior_->energy(field);
  return {};
}

Status LandmarkStep::predict() {
  move_.resize(problem_->shell.vertexCount(), 3);
  sensitivity_.apply(change_, move_);
  move_ += forces_;
  Scalars ofNodes;
  system_->gather(move_, ofNodes);
  batch_ = -ofNodes;
  const Status status = system_->solve(batch_);
  ofNodes = batch_;
  system_->scatter(ofNodes, move_);
  return status;
}

}  // namespace whittle
