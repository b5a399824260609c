#include "methods/local_global/normal_driven/normal_map.h"

#include "methods/local_global/local_global_method.h"

namespace whittle {

Status NormalMapLocalStep::check(const NormalMapParameters& values) {
  if (values.image) return {};
  return Status::failure(Code::badParameter, "normalmap needs an image; give a normal map or a height map as image");
}

std::vector<std::string> NormalMapLocalStep::warnings(const NormalMapParameters& values) {
  if (!values.image || !values.image->slopes.isZero(0)) return {};
  return {
      "The image is flat, so it raises nothing: it may be of one colour, or a color texture in place of a normal or "
      "height map."};
}

void NormalMapLocalStep::prepare(const RestShape& rest, const NormalMapParameters& values) {
  targets_.prepare(rest, values.regularizer, values.lambda, values.lambdaPerVertex);
  const auto raisedNormals = values.regularizer == Rigidity::farap ? raisedFaceNormals : raisedVertexNormals;
  const Points targets = raisedNormals(rest.mesh, targets_.normals(), *values.image, values.strength);
  for (Index k = 0; k < targets_.count(); ++k) targets_.set(k, targets.row(k).transpose());
}

MethodInfo normalmapMethod() {
  using P = NormalMapParameters;
  const ParameterList<P> own = {bind("image", &P::image, Stale::weights, TextureSlopesKind{}),
                                bind("strength", &P::strength, Stale::weights, NumberKind{{-20, 20}}),
                                bind("lambda", &P::lambda, Stale::weights, NumberKind{{0, 1000}}),
                                bind("regularizer", &P::regularizer, Stale::all, rigidities()),
                                bind("lambdaPerVertex", &P::lambdaPerVertex, Stale::weights, ScalarsKind{{0, 1000}}),
                                bind("handles", &P::handles, Stale::system, HandlesKind{}),
                                bind("planes", &P::planes, Stale::system, PlanesKind{}),
                                bind("parts", &P::parts, Stale::system, waysOfParts())};
  return methodInfo<LocalGlobalMethod<NormalMapLocalStep>>("normalmap", withGroup(own, &P::solver, solverParameters()));
}

}  // namespace whittle
