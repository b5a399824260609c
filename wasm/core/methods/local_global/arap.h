#pragma once

#include "methods/local_global/local_step.h"
#include "methods/method.h"

namespace whittle {

/// As rigid as possible: no regularizer, each rotation is the plain Procrustes fit.
class ArapLocalStep : public LocalStep {
 public:
  Rigidity rigidity(const Settings& settings) const override;
  Status prepare(const RestShape&, const Settings&) override { return {}; }
  Lanes fit(std::size_t batch, const MatrixLanes& covariances, bool neverWorse, QuaternionLanes& rotations) override;
};

/// Registry line of the method `arap`: handles move, the rest follows rigidly.
MethodInfo arapMethod();

}  // namespace whittle
