#pragma once

#include <cmath>
#include <limits>

#include "methods/method.h"

namespace whittle {

/// When a local/global iteration ends: a quantity below the tolerance, the iteration limit, or an energy that has long
/// stopped falling. The quantity is
/// - displacement: the longest move of an iteration as a share of the largest displacement from rest (2019, §3.1);
/// - energy: the decrease of two iterations in a row, each as a share of the energy before it (accelerated iterations
///   that turn back decrease it little, once);
/// - iterations: none. Of an energy that changes with the output only the limit ends the run, or a shape at rest.
class StoppingRule {
 public:
  enum class Quantity { displacement, energy, iterations };

  Quantity quantity = Quantity::displacement;
  double tolerance = 3e-3;
  int maxIterations = 1000;

  void begin() {
    iterations_ = 0;
    lowestEnergy_ = std::numeric_limits<double>::infinity();
    lastImprovement_ = 0;
    energyBefore_ = std::numeric_limits<double>::infinity();
    smallDecreases_ = 0;
  }

  /// The longest move of an iteration as a share of the largest displacement, from their squares in the unit frame; 0
  /// where the shape is at rest.
  static double relativeDisplacement(double squaredMove, double squaredDisplacement) {
    return squaredMove <= kNoMove * kNoMove ? 0 : std::sqrt(squaredMove / squaredDisplacement);
  }

  bool exhausted() const { return iterations_ >= maxIterations; }

  /// Judges a finished iteration by its change and the energy before it.
  Outcome judge(const StepReport& report) {
    ++iterations_;
    if (report.energy < lowestEnergy_ - kNoticeable * std::abs(lowestEnergy_) || iterations_ == 1) {
      lowestEnergy_ = report.energy;
      lastImprovement_ = iterations_;
    }
    const bool smallDecrease = iterations_ > 1 && energyBefore_ - report.energy <= tolerance * std::abs(energyBefore_);
    smallDecreases_ = smallDecrease ? smallDecreases_ + 1 : 0;
    energyBefore_ = report.energy;
    // What no longer moves is done by either measure.
    const bool isSmall = quantity == Quantity::energy
                             ? smallDecreases_ >= 2
                             : quantity == Quantity::displacement && report.change <= tolerance;
    if (isSmall || report.change == 0) return Outcome::converged;
    if (quantity != Quantity::iterations && iterations_ - lastImprovement_ >= kPatience) return Outcome::stalled;
    return exhausted() ? Outcome::iterationLimit : Outcome::running;
  }

 private:
  static constexpr double kNoMove = 1e-7;  // a shorter one is rounding
  static constexpr double kNoticeable = 1e-10;
  static constexpr int kPatience = 100;

  int iterations_ = 0;
  int lastImprovement_ = 0;
  double energyBefore_ = 0;
  int smallDecreases_ = 0;
  double lowestEnergy_ = 0;
};

}  // namespace whittle
