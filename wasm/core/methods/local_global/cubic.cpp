#include "methods/local_global/cubic.h"

#include "geometry/rotation_fit.h"
#include "methods/local_global/cubic_admm.h"
#include "methods/local_global/cubic_exact.h"
#include "methods/local_global/local_global.h"

namespace whittle {

namespace {

enum Parameter { kLambda, kLocalStep, kOwnParameters };
enum LocalStepChoice { kExact, kAdmm };

}  // namespace

void CubicLocalStep::prepare(const RestShape& rest, const Settings& settings) {
  const double cubeness = settings.numbers[kLambda];  // λ, Eq. 1
  weights_ = cubeness * rest.areas;
  normals_ = &rest.normals;
  if (static_cast<int>(settings.numbers[kLocalStep]) == kAdmm) {
    solver_ = std::make_unique<CubicAdmm>();
  } else {
    solver_ = std::make_unique<CubicExact>();
  }
  begin();
}

double CubicLocalStep::fit(const std::vector<Mat3>& covariances, const std::vector<Mat3>& guess, bool neverWorse,
                           std::vector<Mat3>& rotations) {
  double energy = 0;
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    const Mat3& M = covariances[i];
    const Vec3 n = normals_->row(i).transpose();
    Mat3& R = rotations[i];
    if (weights_[i] > 0 && !n.isZero(0)) {
      R = guess[i];
      solver_->solve(static_cast<Index>(i), M, n, weights_[i], R);
      if (neverWorse && cubicObjective(M, n, weights_[i], R) < cubicObjective(M, n, weights_[i], guess[i])) R = guess[i];
    } else {
      R = fitRotation(M, guess[i]);
    }
    energy -= cubicObjective(M, n, weights_[i], R);
  }
  return energy;
}

MethodInfo cubicMethod() {
  const auto create = []() -> std::unique_ptr<Method> {
    return std::make_unique<LocalGlobal>(std::make_unique<CubicLocalStep>(), kOwnParameters);
  };
  return {"cubic",
          withSharedParameters({{"lambda", ParameterKind::number, Stale::weights, 0.2, 0, 100},
                                choiceParameter("localStep", Stale::weights, {"exact", "admm"})}),
          create};
}

}  // namespace whittle
