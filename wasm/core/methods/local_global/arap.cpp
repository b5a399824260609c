#include "methods/local_global/arap.h"

#include "geometry/rotation_fit.h"
#include "methods/local_global/local_global.h"

namespace whittle {

Lanes ArapLocalStep::fit(std::size_t, const ScaledCovariances& covariances, bool, QuaternionLanes& rotations) {
  fitRotations(covariances, rotations);
  return splat(0);
}

MethodInfo arapMethod() {
  return {"arap", withSharedParameters({}),
          [] { return std::unique_ptr<Method>(std::make_unique<LocalGlobal>(std::make_unique<ArapLocalStep>(), 0)); }};
}

}  // namespace whittle
