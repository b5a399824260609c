#include "methods/plastic/equilibrium.h"

#include <algorithm>
#include <cmath>

namespace whittle {

namespace {

/// Armijo's condition: of the decrease that the slope promises, what must come.
constexpr double kArmijo = 1e-4;
/// Times that a step is halved before it is given up.
constexpr int kHalvings = 12;
/// No step moves a vertex farther, in a unit in which the whole shape is 100 long.
constexpr double kLongestMove = 10;
/// When the factor has become old: steps with it, and steps that had to be cut.
constexpr int kFactorSteps = 25, kSlowSteps = 4;

}  // namespace

void Equilibrium::begin(Shell& shell, ShellSystem& system, const RigidModes& modes, const Points& positions,
                        const Limits& limits) {
  shell_ = &shell;
  system_ = &system;
  modes_ = &modes;
  limits_ = limits;
  positions_ = positions;
  forces_.resize(positions.rows(), 3);
  memory_.forget();
  steps_ = stepsOfFactor_ = slow_ = 0;
  isFactoring_ = false;
  shell_->setShape(positions_);
  energy_ = shell_->energy(forces_);
  system_->gather(forces_, gradient_);
  end_ = std::isfinite(energy_) && gradient_.allFinite() ? End::none : End::pressed;
}

Status Equilibrium::next() {
  if (isFactoring_) {
    double share = 0;
    const Status status = system_->factorizeNext(share);
    isFactoring_ = share < 1;
    return status;
  }
  const auto inverse = [this](Scalars& vector) {
    ShellSystem::Rows rows = vector;
    system_->approximate(rows);
    vector = rows;
  };
  memory_.direction(gradient_, inverse, direction_);
  system_->scatter(direction_, move_);
  const bool isShorter = search();
  ++steps_;
  if (!isShorter || lastMove_ < limits_.tolerance) {
    end_ = End::rest;
  } else if (shell_->smallestSquaredStretch() < limits_.leastSquaredStretch) {
    end_ = End::pressed;
  } else if (steps_ >= limits_.steps) {
    end_ = End::limit;
  } else if (++stepsOfFactor_ >= kFactorSteps || slow_ >= kSlowSteps) {
    system_->beginFactorize(*shell_, *modes_);
    memory_.forget();
    isFactoring_ = true;
    stepsOfFactor_ = slow_ = 0;
  }
  if (end_ == End::rest && shell_->smallestSquaredStretch() < limits_.leastSquaredStretch) end_ = End::pressed;
  return {};
}

/// Goes along the direction as far as the energy falls; returns whether it went.
bool Equilibrium::search() {
  const double slope = gradient_.dot(direction_), farthest = move_.rowwise().norm().maxCoeff();
  double length = std::min(1.0, kLongestMove / farthest);
  if (!(slope < 0) || !std::isfinite(length)) return false;
  int halvings = 0;
  for (; halvings < kHalvings; ++halvings, length /= 2) {
    trial_ = positions_ + length * move_;
    shell_->setShape(trial_);
    const double energy = shell_->energy();
    if (energy <= energy_ + kArmijo * length * slope) break;
  }
  if (halvings == kHalvings) {
    shell_->setShape(positions_);
    return false;
  }
  if (halvings >= 2) ++slow_;
  positions_ = trial_;
  energy_ = shell_->energy(forces_);
  gradientBefore_ = gradient_;
  system_->gather(forces_, gradient_);
  direction_ *= length;
  memory_.remember(direction_, gradient_ - gradientBefore_);
  lastMove_ = length * farthest;
  return true;
}

}  // namespace whittle
