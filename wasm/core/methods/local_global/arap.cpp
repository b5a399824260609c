#include "methods/local_global/arap.h"

#include "geometry/rotation_fit.h"
#include "methods/local_global/local_global.h"

namespace whittle {

double ArapLocalStep::fit(const std::vector<Mat3>& covariances, const std::vector<Mat3>& guess, bool,
                          std::vector<Mat3>& rotations) {
  double energy = 0;
  for (std::size_t k = 0; k < rotations.size(); ++k) {
    rotations[k] = fitRotation(covariances[k], guess[k]);
    energy -= rotations[k].cwiseProduct(covariances[k].transpose()).sum();  // tr(R M)
  }
  return energy;
}

MethodInfo arapMethod() {
  return {"arap", withSharedParameters({}),
          [] { return std::unique_ptr<Method>(std::make_unique<LocalGlobal>(std::make_unique<ArapLocalStep>(), 0)); }};
}

}  // namespace whittle
