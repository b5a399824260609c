#pragma once

#include <memory>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "methods/field.h"
#include "methods/parameter_values.h"
#include "methods/stage.h"

namespace whittle {

enum class Outcome {
  running,
  midway,  // of an iteration that takes long: there is no report yet, and the next step goes on with it
  converged,
  iterationLimit,
  stalled
};

/// The name that TypeScript knows an outcome by, e.g. "iteration-limit".
const char* outcomeName(Outcome outcome);

/// What one step says.
struct StepReport {
  Outcome outcome = Outcome::running;
  double energy = 0;  // before the step, with the local step's new rotations (unit frame)
  double change = 0;  // relative displacement: longest move of the step over the largest displacement from rest
};

/// A method at work on one mesh. The rest mesh is in the unit frame and outlives the method. Its vertices are in an
/// elimination order, as sparse systems on its graph want them (`Ordering::isOrdered`), and so are those of the values;
/// failures therefore name no element.
class Method {
 public:
  virtual ~Method() = default;

  /// Refuses values that do not go together, or of which one is missing, before anything is computed.
  virtual Status check(const ParameterValues& values) const = 0;

  /// What is to be done about what is stale, the highest level first. Stages read the values when they run: one that is
  /// set in between and makes stale only what has not been done yet is taken as it is then. Values and rest outlive the
  /// stages.
  virtual std::vector<Stage> plan(const TriangleMesh& rest, const ParameterValues& values, Stale stale) = 0;

  /// Starts a run (iteration count, stopping rule, local state) of a prepared method from the given positions, moving
  /// them where constraints hold them.
  virtual void begin(Points& positions) = 0;

  /// One iteration, in place, or a part of one that takes long. Allocates nothing. After a failure the positions are those before it.
  virtual Status step(Points& positions, StepReport& report) = 0;

  /// What a person should know of these settings on this mesh, a sentence each.
  virtual std::vector<std::string> warnings(const ParameterValues& values) const = 0;

  /// The fields that it can show, prepared or running.
  virtual std::vector<Field> fields() const { return {}; }
};

/// A method whose parameters are a P: it sees nothing but its own struct.
template <typename P>
class MethodOf : public Method {
 public:
  using Parameters = P;

  virtual Status check(const P&) const { return {}; }
  virtual std::vector<Stage> plan(const TriangleMesh& rest, const P& values, Stale stale) = 0;
  virtual std::vector<std::string> warnings(const P&) const { return {}; }

  Status check(const ParameterValues& values) const final { return check(structOf(values)); }
  std::vector<Stage> plan(const TriangleMesh& rest, const ParameterValues& values, Stale stale) final {
    return plan(rest, structOf(values), stale);
  }
  std::vector<std::string> warnings(const ParameterValues& values) const final { return warnings(structOf(values)); }

 private:
  static const P& structOf(const ParameterValues& values) {
    return static_cast<const BoundValues<P>&>(values).values();
  }
};

/// A line of the registry.
struct MethodInfo {
  const char* id;
  std::unique_ptr<Method> (*create)();
  std::function<std::unique_ptr<ParameterValues>()> defaults;
  /// Says why a mesh, its vertices as they were loaded, is not for this method: `unsuitableMesh`. nullptr: all are.
  Status (*acceptsMesh)(const TriangleMesh& mesh) = nullptr;
};

/// The line of a method class M, a `MethodOf` its parameters.
template <typename M>
MethodInfo methodInfo(const char* id, ParameterList<typename M::Parameters> parameters,
                      Status (*acceptsMesh)(const TriangleMesh& mesh) = nullptr) {
  return {id, []() -> std::unique_ptr<Method> { return std::make_unique<M>(); },
          [parameters = std::move(parameters)]() -> std::unique_ptr<ParameterValues> {
            return std::make_unique<BoundValues<typename M::Parameters>>(parameters);
          },
          acceptsMesh};
}

}  // namespace whittle
