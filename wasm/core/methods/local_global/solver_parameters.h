#pragma once

#include "methods/local_global/acceleration.h"
#include "methods/parameter.h"
#include "methods/stopping_rule.h"

namespace whittle {

/// How a local/global method goes about its iterations, and when it stops.
struct SolverParameters {
  Acceleration::Kind acceleration = Acceleration::Kind::nesterov;
  StoppingRule::Quantity stopOn = StoppingRule::Quantity::displacement;
  double tolerance = 3e-3;
  int maxIterations = 1000;
};

ParameterList<SolverParameters> solverParameters();

}  // namespace whittle
