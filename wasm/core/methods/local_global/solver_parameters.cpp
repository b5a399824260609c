#include "methods/local_global/solver_parameters.h"

namespace whittle {

ParameterList<SolverParameters> solverParameters() {
  using P = SolverParameters;
  using Kind = Acceleration::Kind;
  using Quantity = StoppingRule::Quantity;
  const ChoiceKind<Kind> accelerations{
      {{"nesterov", Kind::nesterov}, {"relaxed", Kind::relaxed}, {"none", Kind::none}}};
  const ChoiceKind<Quantity> quantities{{{"displacement", Quantity::displacement}, {"energy", Quantity::energy}}};
  return {bind("acceleration", &P::acceleration, Stale::targets, accelerations),
          bind("stopOn", &P::stopOn, Stale::targets, quantities),
          bind("tolerance", &P::tolerance, Stale::targets, NumberKind{{0, 1}}),
          bind("maxIterations", &P::maxIterations, Stale::targets, kIterations)};
}

}  // namespace whittle
