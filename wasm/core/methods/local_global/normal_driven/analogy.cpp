#include "methods/local_global/normal_driven/analogy.h"

#include "geometry/surface.h"
#include "methods/local_global/local_global.h"

namespace whittle {

namespace {

enum Parameter { kStyle, kLambda, kRegularizer, kDynamicTargets, kLambdaPerVertex, kOwnParameters };

}  // namespace

Rigidity AnalogyLocalStep::rigidity(const Settings& settings) const { return static_cast<Rigidity>(settings.numbers[kRegularizer]); }

Status AnalogyLocalStep::prepare(const RestShape& rest, const Settings& settings) {
  if (!settings.style) {
    return Status::failure(Code::badParameter, "an analogy needs a style; choose one, for example the cube");
  }
  style_ = settings.style;
  triangles_ = &rest.mesh.triangles;
  rigidity_ = rigidity(settings);
  isDynamic_ = settings.numbers[kDynamicTargets] != 0;
  targets_.prepare(rest, rigidity_, settings.numbers[kLambda], settings.scalars[kLambdaPerVertex]);
  present_ = targets_.normals();
  scratch_.resize(rest.mesh.vertexCount());
  lookUpTargets();
  return {};
}

void AnalogyLocalStep::observe(const Points& positions) {
  if (!isDynamic_) return;
  if (rigidity_ == Rigidity::farap) {
    faceNormals(positions, *triangles_, present_);
  } else {
    vertexNormals(positions, *triangles_, present_, scratch_);
  }
  lookUpTargets();
}

void AnalogyLocalStep::lookUpTargets() {
  for (Index k = 0; k < targets_.count(); ++k) {
    const Vec3 n = present_.row(k).transpose();
    if (targets_.strengths()[k] != 0 && !n.isZero(0)) targets_.set(k, (*style_)(n));
  }
}

MethodInfo analogyMethod() {
  const auto create = []() -> std::unique_ptr<Method> {
    return std::make_unique<LocalGlobal>(std::make_unique<AnalogyLocalStep>(), kOwnParameters);
  };
  return {"analogy",
          withSharedParameters({{"style", ParameterKind::style, Stale::weights},
                                {"lambda", ParameterKind::number, Stale::weights, 1, 0, 100},
                                rigidityParameter(),
                                flagParameter("dynamicTargets", Stale::weights),
                                {"lambdaPerVertex", ParameterKind::scalars, Stale::weights, 0, 0, 100}}),
          create};
}

}  // namespace whittle
