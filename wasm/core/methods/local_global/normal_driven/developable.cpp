#include "methods/local_global/normal_driven/developable.h"

#include "methods/local_global/local_global.h"

namespace whittle {

namespace {

enum Parameter { kLambda, kCreases, kLambdaPerVertex, kOwnParameters };

}  // namespace

Status DevelopableLocalStep::prepare(const RestShape& rest, const Settings& settings) {
  targets_.prepare(rest, Rigidity::farap, settings.numbers[kLambda], settings.scalars[kLambdaPerVertex]);
  normals_.prepare(rest.mesh, settings.numbers[kCreases]);
  return {};
}

void DevelopableLocalStep::observe(const Points& positions) {
  normals_.observe(positions);
  for (Index f = 0; f < targets_.count(); ++f) {
    const Vec3 target = normals_(f);
    const double length = target.norm();
    if (targets_.strengths()[f] != 0 && length > 0) targets_.set(f, target / length);
  }
}

MethodInfo developableMethod() {
  const auto create = []() -> std::unique_ptr<Method> {
    return std::make_unique<LocalGlobal>(std::make_unique<DevelopableLocalStep>(), kOwnParameters, Ending::iterations);
  };
  return {"developable",
          withIterations({{"lambda", ParameterKind::number, Stale::weights, 20, 0, 1000},
                          {"creases", ParameterKind::number, Stale::weights, 0.65, 0, 1},
                          {"lambdaPerVertex", ParameterKind::scalars, Stale::weights, 0, 0, 1000}},
                         150),
          create};
}

}  // namespace whittle
