// Read first: README.md beside this, from equation to file, and wasm/reference, the same alternation in plain Eigen.
#pragma once

#include <limits>
#include <vector>

#include "methods/alternating/anderson.h"
#include "methods/alternating/transformation_system.h"
#include "methods/alternating/vertex_system.h"
#include "methods/method.h"

namespace whittle {

/// When a run ends (App. A). Lengths in the unit frame.
struct AlternationLimits {
  int iterations = 100;
  double tolerance = 1e-3;  // of each vertex solve, of what is left to do
  MatrixFieldSystem::Limits transformations;
  /// The move of an iteration times a fifth of their number, below which nobody sees what is still to come: of vertices
  /// out of their faces, and of vertices at all. 0: as printed, only moves below a hundredth of the mean edge end the
  /// run.
  double unseenMove = 0, unseenSlide = 0;
  /// What the last fifth of the iterations may have moved for a run to end because its energy hardly falls. Infinite as
  /// printed, where shapes are left on their way.
  double lateMove = std::numeric_limits<double>::infinity();
  /// Whether iterations are accelerated: they end where those that are not would go if they were let.
  bool isAccelerated = false;
};

/// The alternating solves of a run: vertices for given transformations, transformations for given vertices. It ends when
/// the energy rises (the best positions count), when nothing moves, when the energy hardly falls, or at the limit.
class Alternation {
 public:
  /// Starts from the rest shape. Surface and systems, prepared, are kept by the caller.
  void begin(const RestSurface& surface, const EnergyWeights& weights, VertexSystem& vertices,
             TransformationSystem& transformations, const AlternationLimits& limits);
  /// Starts from positions that an earlier run of the same surface came to: transformations are those that suit them.
  void resume(const Points& positions);
  /// Lets the run go on after another one has used its systems: an iteration that was midway is begun anew.
  void takeUp() { stage_ = firstStage_; }

  /// Does a slice of an iteration; all but its last ones report `midway`. Allocates nothing. Fails with
  /// `numericalFailure`.
  Status iterate(StepReport& report);

  const Points& positions() const { return positions_; }
  const Transformations& transformations() const { return tau_; }

 private:
  enum class Stage { beginning, transformations, assembling, vertices };

  void beginTransformations();
  void setGoals();
  Status report(StepReport& report);
  double moveOutOfFaces() const;
  double lateMove() const;
  Outcome judge(double energy, double move, double moveOutOfFaces);
  void chooseStart();

  const RestSurface* surface_ = nullptr;
  EnergyWeights weights_;
  VertexSystem* vertices_ = nullptr;
  TransformationSystem* system_ = nullptr;
  AlternationLimits limits_;

  Stage stage_ = Stage::assembling, firstStage_ = Stage::assembling;  // now; of this iteration
  Points positions_, best_;
  Points start_;  // what the transformations are to suit: the positions, or what they seem to be going to
  Anderson acceleration_;
  Points next_;       // while the vertex solve goes on
  Points halfEdges_;  // e, 3#F×3
  Transformations tau_;
  EdgeGoals goals_;
  int iterations_ = 0;
  std::vector<double> moved_;  // by each iteration and those before, at most
  double energyBefore_ = 0, bestEnergy_ = 0;
};

}  // namespace whittle
