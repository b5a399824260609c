#pragma once

#include "methods/local_global/local_global.h"

namespace whittle {

struct ArapParameters {
  Rigidity regularizer = Rigidity::arap;
  Handles handles;
  Planes planes;
  Parts parts = Parts::together;
  SolverParameters solver;
};

/// As rigid as possible: no regularizer, each rotation is the plain Procrustes fit.
class ArapLocalStep : public LocalStep {
 public:
  using Parameters = ArapParameters;
  static EngineValues engineValues(const ArapParameters& values) {
    return {values.regularizer, values.handles, values.solver, values.parts, values.planes};
  }
  static Status check(const ArapParameters&) { return {}; }
  static std::vector<std::string> warnings(const ArapParameters& values);

  void prepare(const RestShape&, const ArapParameters&) {}
  Lanes fit(std::size_t batch, const MatrixLanes& covariances, bool neverWorse, QuaternionLanes& rotations) override;
};

/// Registry line of the method `arap`: handles move, the rest follows rigidly.
MethodInfo arapMethod();

}  // namespace whittle
