#include "methods/local_global/arap.h"

#include "geometry/rotation_fit.h"
#include "methods/local_global/local_global.h"

namespace whittle {

namespace {

enum Parameter { kRegularizer, kOwnParameters };

}  // namespace

Rigidity ArapLocalStep::rigidity(const Settings& settings) const { return static_cast<Rigidity>(settings.numbers[kRegularizer]); }

Lanes ArapLocalStep::fit(std::size_t, const MatrixLanes& covariances, bool, QuaternionLanes& rotations) {
  fitRotations(covariances, rotations);
  return splat(0);
}

MethodInfo arapMethod() {
  const auto create = []() -> std::unique_ptr<Method> {
    return std::make_unique<LocalGlobal>(std::make_unique<ArapLocalStep>(), kOwnParameters);
  };
  return {"arap", withSharedParameters({rigidityParameter()}), create};
}

}  // namespace whittle
