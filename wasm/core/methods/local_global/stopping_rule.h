#pragma once

#include <cmath>
#include <limits>

#include "methods/method.h"

namespace whittle {

/// When a local/global iteration ends: relative displacement below the tolerance (2019, §3.1), the iteration limit, or an
/// energy that has long stopped falling.
class StoppingRule {
 public:
  double tolerance = 3e-3;
  int maxIterations = 1000;

  void begin() {
    iterations_ = 0;
    lowestEnergy_ = std::numeric_limits<double>::infinity();
    lastImprovement_ = 0;
  }

  bool exhausted() const { return iterations_ >= maxIterations; }

  /// Judges a finished iteration by its change and the energy before it.
  Outcome judge(const StepReport& report) {
    ++iterations_;
    if (report.energy < lowestEnergy_ - kNoticeable * std::abs(lowestEnergy_) || iterations_ == 1) {
      lowestEnergy_ = report.energy;
      lastImprovement_ = iterations_;
    }
    if (report.change <= tolerance) return Outcome::converged;
    if (iterations_ - lastImprovement_ >= kPatience) return Outcome::stalled;
    return exhausted() ? Outcome::iterationLimit : Outcome::running;
  }

 private:
  static constexpr double kNoticeable = 1e-10;
  static constexpr int kPatience = 100;

  int iterations_ = 0;
  int lastImprovement_ = 0;
  double lowestEnergy_ = 0;
};

}  // namespace whittle
