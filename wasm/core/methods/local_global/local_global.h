// Read first: README.md beside this, from equation to file, and wasm/reference, the same iteration in plain Eigen.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "constraints/contact_search.h"
#include "constraints/gauge.h"
#include "constraints/planes.h"
#include "linear/constrained_quadratic.h"
#include "methods/local_global/acceleration.h"
#include "methods/local_global/best_iterate.h"
#include "methods/local_global/free_scales.h"
#include "methods/local_global/local_step.h"
#include "methods/local_global/rigidity.h"
#include "methods/local_global/solver_parameters.h"
#include "methods/method.h"
#include "methods/parts.h"

namespace whittle {

/// What the engine needs of a method's values.
struct EngineValues {
  Rigidity rigidity = Rigidity::arap;
  Handles handles;
  SolverParameters solver;
  Parts parts = Parts::together;
  Planes planes;
};

/// The engine of all local/global methods.
///
/// Minimises Σ_k Σ_{e∈N(k)} c_e |s_k R_k d_e − u_e|² + regularizer(R), s_k = 1 unless the policy frees it, alternating
/// between the rotations R (local step, the policy) and the positions (global step, one Poisson solve with handles
/// eliminated, vertices on planes held there and what is loose held by its gauge). Parts that touch are tied by `Attachments`, whose energy belongs to
/// it. The energy of the points that iterations start from never rises,
/// accelerated or not.
class LocalGlobal {
 public:
  /// @param localStep the policy; outlives the engine
  explicit LocalGlobal(LocalStep& localStep) : localStep_(localStep) {}

  /// @param values what the stages read when they run
  /// @param prepareStep prepares the policy for a rest shape that outlives its use
  std::vector<Stage> plan(const TriangleMesh& rest, std::function<EngineValues()> values,
                          std::function<void(const RestShape& rest)> prepareStep, Stale stale);
  void begin(Points& positions);
  Status step(Points& positions, StepReport& report);
  std::vector<Field> fields() const;
  /// What a person should know of the run so far.
  std::vector<std::string> warnings() const;

 private:
  void measure(const TriangleMesh& rest);
  void beginCollecting(Rigidity rigidity);
  void collectEdges(double& done);
  void claimRunningState();
  void findContacts(double& done);
  void assembleSystem(const EngineValues& values);
  /// Puts vertices where handles and planes hold them.
  void applyConstraints(Points& positions) const;
  /// Where the rotations of a local step start from.
  enum class Guess {
    continued,  // where they would go on to as they last turned: about half as many steps; for an iteration's first only
    last,       // the rotations of the iteration before
    bound,      // the rotations of the iteration before, and none may get worse than it was
  };

  /// Fits the rotations to the displacements and leaves the residual of the global step; returns the energy.
  double localStep(const Displacements& displacements, Guess guess);
  /// Fits the rotations of elements whose covariances are there and leaves their rotation changes; returns what these
  /// change in the energy.
  double fitBlock(ElementRange block, Guess guess);
  /// Moves the displacements from where the iteration started to the minimum for the rotations and writes the
  /// positions. Returns the longest move of a vertex as a share of the largest displacement, or not a number where one
  /// is not. Of an accelerated iteration both moves must be short: from where it started, which is what the plain one
  /// would report there, and from the iterate before.
  double globalStep(Points& positions);

  LocalStep& localStep_;
  StoppingRule stopping_;
  Acceleration::Kind accelerationKind_ = Acceleration::Kind::nesterov;
  Handles handles_;
  std::vector<HeldRow> onPlanes_;

  // Prepared once per rest shape
  std::optional<RestShape> rest_;
  CornerScalars halfCotangents_;
  std::unique_ptr<EdgeSet> edges_;
  double sizeOfTerms_ = 0;  // Σ tr(M⁰_k)
  Components components_;
  std::unique_ptr<ContactSearch> contactSearch_;  // while it goes on
  Attachments contacts_;

  // Prepared once per set of held vertices and directions of planes
  Attachments attachments_;  // the contacts, or none where parts are free
  std::optional<Gauge> gauge_;
  ConstrainedQuadratic system_;

  // Running state, claimed by the first run on a rest shape: the memory of the factorization, which is the peak, is
  // free by then
  bool isClaimed_ = false;
  std::vector<QuaternionLanes> guess_;  // rotations of the iteration before, which made the present positions
  std::vector<QuaternionLanes> rotations_;
  std::optional<FreeScales> scales_;          // where the policy frees them
  std::vector<MatrixLanes> covariances_;      // of one block
  std::vector<MatrixLanes> rotationChanges_;  // of one block
  LaneRows residual_;                         // b − L V; then the corrections
  Displacements displacements_;               // of the iterate
  Displacements previous_;                    // of the iterate before
  Acceleration acceleration_;
  double energy_ = 0;  // of the point that the last iteration started from
  BestIterate best_;
};

}  // namespace whittle
