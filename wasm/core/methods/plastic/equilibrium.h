#pragma once

#include "methods/plastic/shell_system.h"
#include "optimization/limited_memory.h"

namespace whittle {

/// Brings a shell to rest under what is plastic about it: steps with memory over the factor of its stiffness at rest,
/// which is taken anew only where they stay short.
class Equilibrium {
 public:
  /// What a descent ended with.
  enum class End { none, rest, pressed, limit };

  /// @param tolerance no vertex moves farther in the last step
  /// @param leastSquaredStretch of a shell that is pressed together more the descent is given up
  struct Limits {
    double tolerance = 0.01;
    double leastSquaredStretch = 0.34;
    int steps = 75;
  };

  /// Starts from positions. Shell, system and modes are kept by the caller until the end; the system holds the factor.
  void begin(Shell& shell, ShellSystem& system, const RigidModes& modes, const Points& positions, const Limits& limits);
  /// Does a step, or a slice of a factorization. Fails as that does.
  Status next();
  End end() const { return end_; }
  int steps() const { return steps_; }

  /// Where it is; the shell is in this shape.
  const Points& positions() const { return positions_; }

 private:
  bool search();

  Shell* shell_ = nullptr;
  ShellSystem* system_ = nullptr;
  const RigidModes* modes_ = nullptr;
  Limits limits_;
  LimitedMemory memory_;
  Points positions_, trial_, move_;
  Points forces_;
  double energy_ = 0;
  Scalars gradient_, gradientBefore_, direction_;
  int steps_ = 0, stepsOfFactor_ = 0, slow_ = 0;
  bool isFactoring_ = false;
  double lastMove_ = 0;
  End end_ = End::none;
};

}  // namespace whittle
