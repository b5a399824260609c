#pragma once

#include <concepts>

#include "methods/local_global/local_global.h"

namespace whittle {

/// A local step with a struct of parameters of its own.
template <typename Step>
concept LocalStepPolicy = std::derived_from<Step, LocalStep> &&
    requires(Step step, const RestShape& rest, const typename Step::Parameters& values) {
  /// What the engine needs of the values.
  { Step::engineValues(values) } -> std::same_as<EngineValues>;
  /// Refuses values that do not go together.
  { Step::check(values) } -> std::same_as<Status>;
  /// Takes the values; called when weights or more are stale. `rest` outlives the step's use.
  step.prepare(rest, values);
  /// What a person should know of the values.
  { Step::warnings(values) } -> std::same_as<std::vector<std::string>>;
};

/// A local/global method: the engine at work with a policy.
template <LocalStepPolicy Step>
class LocalGlobalMethod final : public MethodOf<typename Step::Parameters> {
 public:
  using Parameters = typename Step::Parameters;

  Status check(const Parameters& values) const override {
    if (Status status = Step::check(values); !status.ok()) return status;
    const EngineValues held = Step::engineValues(values);
    return validateHandlesOnPlanes(held.handles, held.planes);
  }
  std::vector<Stage> plan(const TriangleMesh& rest, const Parameters& values, Stale stale) override {
    return engine_.plan(
        rest, [&values] { return Step::engineValues(values); },
        [this, &values](const RestShape& shape) { step_.prepare(shape, values); }, stale);
  }
  void begin(Points& positions) override { engine_.begin(positions); }
  Status step(Points& positions, StepReport& report) override { return engine_.step(positions, report); }
  std::vector<std::string> warnings(const Parameters& values) const override {
    std::vector<std::string> all = Step::warnings(values);
    for (std::string& warning : engine_.warnings()) all.push_back(std::move(warning));
    return all;
  }
  std::vector<Field> fields() const override { return engine_.fields(); }

 private:
  Step step_;
  LocalGlobal engine_{step_};
};

}  // namespace whittle
