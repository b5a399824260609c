#include "methods/local_global/normal_driven/developable.h"

#include "methods/local_global/local_global_method.h"

namespace whittle {

EngineValues DevelopableLocalStep::engineValues(const DevelopableParameters& values) {
  SolverParameters solver;
  solver.stopOn = StoppingRule::Quantity::iterations;
  solver.maxIterations = values.maxIterations;
  return {Rigidity::farap, values.handles, solver, values.parts, values.planes};
}

void DevelopableLocalStep::prepare(const RestShape& rest, const DevelopableParameters& values) {
  targets_.prepare(rest, Rigidity::farap, values.lambda, values.lambdaPerVertex);
  normals_.prepare(rest.mesh, values.creases);
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
  using P = DevelopableParameters;
  return methodInfo<LocalGlobalMethod<DevelopableLocalStep>>(
      "developable",
      {bind("lambda", &P::lambda, Stale::weights, NumberKind{{0, 1000}}),
       bind("creases", &P::creases, Stale::weights, NumberKind{{0, 1}}),
       bind("lambdaPerVertex", &P::lambdaPerVertex, Stale::weights, ScalarsKind{{0, 1000}}),
       bind("handles", &P::handles, Stale::system, HandlesKind{}),
       bind("planes", &P::planes, Stale::system, PlanesKind{}), bind("parts", &P::parts, Stale::system, waysOfParts()),
       bind("maxIterations", &P::maxIterations, Stale::targets, kIterations)});
}

}  // namespace whittle
