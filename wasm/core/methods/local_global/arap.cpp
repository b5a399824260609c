#include "methods/local_global/arap.h"

#include "geometry/rotation_fit.h"
#include "methods/local_global/local_global_method.h"

namespace whittle {

std::vector<std::string> ArapLocalStep::warnings(const ArapParameters& values) {
  if (!values.handles.vertices.empty() || !values.planes.empty()) return {};
  return {"Nothing is held, so nothing moves: arap needs handles or planes; hold some vertices and drag others."};
}

Lanes ArapLocalStep::fit(std::size_t, const MatrixLanes& covariances, bool, QuaternionLanes& rotations) {
  fitRotations(covariances, rotations);
  return splat(0);
}

MethodInfo arapMethod() {
  using P = ArapParameters;
  const ParameterList<P> own = {bind("regularizer", &P::regularizer, Stale::all, rigidities()),
                                bind("handles", &P::handles, Stale::system, HandlesKind{}),
                                bind("planes", &P::planes, Stale::system, PlanesKind{}),
                                bind("parts", &P::parts, Stale::system, waysOfParts())};
  return methodInfo<LocalGlobalMethod<ArapLocalStep>>("arap", withGroup(own, &P::solver, solverParameters()));
}

}  // namespace whittle
