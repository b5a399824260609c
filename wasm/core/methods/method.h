#pragma once

#include <memory>

#include "mesh/triangle_mesh.h"
#include "methods/parameters.h"

namespace whittle {

enum class Outcome { running, converged, iterationLimit, stalled };

/// What one step says.
struct StepReport {
  Outcome outcome = Outcome::running;
  double energy = 0;  // before the step, with the local step's new rotations (unit frame)
  double change = 0;  // relative displacement: longest move of the step over the largest displacement from rest
};

/// A method at work on one mesh. The rest mesh is in the unit frame and outlives the method. Its vertices are numbered in an elimination
/// order, as sparse systems on its graph want them (`Ordering::isOrdered`).
class Method {
 public:
  virtual ~Method() = default;

  /// Computes what is stale. Costs nothing for `Stale::nothing`.
  virtual Status prepare(const TriangleMesh& rest, const Settings& settings, Stale stale) = 0;

  /// Starts a run (iteration count, stopping rule, local state) from the given positions, moving them where constraints
  /// hold them.
  virtual void begin(Points& positions) = 0;

  /// One iteration, in place. Allocates nothing.
  virtual Status step(Points& positions, StepReport& report) = 0;
};

/// A line of the registry.
struct MethodInfo {
  const char* id;
  std::vector<ParameterInfo> parameters;
  std::unique_ptr<Method> (*create)();
  /// Says why a mesh, numbered as in the file, is not for this method: `unsuitableMesh`. nullptr: all are.
  Status (*acceptsMesh)(const TriangleMesh& mesh) = nullptr;
};

}  // namespace whittle
