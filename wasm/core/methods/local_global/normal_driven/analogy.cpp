#include "methods/local_global/normal_driven/analogy.h"

#include "geometry/surface.h"
#include "methods/local_global/local_global_method.h"

namespace whittle {

Status AnalogyLocalStep::check(const AnalogyParameters& values) {
  if (values.style) return {};
  return Status::failure(Code::badParameter, "an analogy needs a style; choose one, for example the cube");
}

void AnalogyLocalStep::prepare(const RestShape& rest, const AnalogyParameters& values) {
  style_ = values.style;
  rest_ = &rest;
  rigidity_ = values.regularizer;
  isDynamic_ = values.dynamicTargets;
  if (rigidity_ == Rigidity::farap) {
    targets_.prepare(rest, rigidity_, values.lambda, values.lambdaPerVertex);
  } else {
    targets_.prepareFans(rest, values.lambda, values.lambdaPerVertex);
  }
  if (values.lambdaOnGaussMap) targets_.weaken(*values.lambdaOnGaussMap);
  present_ = targets_.normals();
  scratch_.resize(targets_.count());
  lookUpTargets();
}

void AnalogyLocalStep::observe(const Points& positions) {
  if (!isDynamic_) return;
  if (rigidity_ == Rigidity::farap) {
    faceNormals(positions, rest_->mesh.triangles, present_);
  } else {
    fanNormals(positions, rest_->mesh.triangles, rest_->fans, present_, scratch_);
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
  using P = AnalogyParameters;
  const ParameterList<P> own = {bind("style", &P::style, Stale::weights, StyleKind{}),
                                bind("lambda", &P::lambda, Stale::weights, NumberKind{{0, 100}}),
                                bind("regularizer", &P::regularizer, Stale::all, rigidities()),
                                bind("dynamicTargets", &P::dynamicTargets, Stale::weights, FlagKind{}),
                                bind("lambdaPerVertex", &P::lambdaPerVertex, Stale::weights, ScalarsKind{{0, 100}}),
                                bind("lambdaOnGaussMap", &P::lambdaOnGaussMap, Stale::weights, SphereFieldKind{}),
                                bind("handles", &P::handles, Stale::system, HandlesKind{}),
                                bind("planes", &P::planes, Stale::system, PlanesKind{}),
                                bind("parts", &P::parts, Stale::system, waysOfParts())};
  return methodInfo<LocalGlobalMethod<AnalogyLocalStep>>("analogy", withGroup(own, &P::solver, solverParameters()));
}

}  // namespace whittle
