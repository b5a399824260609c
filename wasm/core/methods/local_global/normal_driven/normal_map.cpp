#include "methods/local_global/normal_driven/normal_map.h"

#include "methods/local_global/local_global.h"

namespace whittle {

namespace {

enum Parameter { kImage, kStrength, kLambda, kRegularizer, kLambdaPerVertex, kOwnParameters };

/// Heights are details, and sizes may change for them (2021, §4.1).
ParameterInfo conformalByDefault() {
  ParameterInfo info = rigidityParameter();
  info.defaultValue = static_cast<double>(Rigidity::acap);
  return info;
}

}  // namespace

Rigidity NormalMapLocalStep::rigidity(const Settings& settings) const { return static_cast<Rigidity>(settings.numbers[kRegularizer]); }

Status NormalMapLocalStep::prepare(const RestShape& rest, const Settings& settings) {
  if (!settings.textureSlopes) {
    return Status::failure(Code::badParameter, "normalmap needs a picture; give a normal map or a height map as image");
  }
  const Rigidity kind = rigidity(settings);
  targets_.prepare(rest, kind, settings.numbers[kLambda], settings.scalars[kLambdaPerVertex]);
  const auto raisedNormals = kind == Rigidity::farap ? raisedFaceNormals : raisedVertexNormals;
  const Points targets = raisedNormals(rest.mesh, targets_.normals(), *settings.textureSlopes, settings.numbers[kStrength]);
  for (Index k = 0; k < targets_.count(); ++k) targets_.set(k, targets.row(k).transpose());
  return {};
}

MethodInfo normalmapMethod() {
  const auto create = []() -> std::unique_ptr<Method> {
    return std::make_unique<LocalGlobal>(std::make_unique<NormalMapLocalStep>(), kOwnParameters);
  };
  return {"normalmap",
          withSharedParameters({{"image", ParameterKind::textureSlopes, Stale::weights},
                                {"strength", ParameterKind::number, Stale::weights, 1, -20, 20},
                                {"lambda", ParameterKind::number, Stale::weights, 10, 0, 1000},
                                conformalByDefault(),
                                {"lambdaPerVertex", ParameterKind::scalars, Stale::weights, 0, 0, 1000}}),
          create};
}

}  // namespace whittle
