#pragma once

#include <memory>
#include <optional>
#include <string>

#include "methods/alternating/alternation.h"
#include "methods/alternating/fold_check.h"
#include "methods/alternating/reshape_terms.h"
#include "methods/alternating/run_behind.h"

namespace whittle {

/// What a run is asked for, in the unit frame.
struct RunSettings {
  Variant variant = Variant::slippage;
  Reading reading = Reading::tuned;
  FeatureSettings features;
  double diagonal = 1;  // of the bounding box
};

/// The rows of a run: handles first.
struct RunRows {
  std::vector<PointRow> handles;
  std::vector<PointRow> others;  // straight lines, ties between parts, pins
};

/// Runs of the alternation on one working mesh, from a gesture to a result that can be kept: where a handle is missed by
/// much, once more with the output for input; where next to handles errors pile up, these are spread; where a face folds
/// over, again with less of what keeps round parts.
class ReshapeRun {
 public:
  /// Begins to take a surface; `prepareNext` does it slice by slice.
  /// @param rest, structure to be kept by the caller, their terms not set
  void shape(const RestSurface& rest, const Structure& structure, const RunSettings& settings, RunRows rows);
  Status prepareNext(double& share) { return first_->prepareNext(share); }

  /// Other targets for the same handles.
  void aim(const std::vector<Vec3>& targets);
  void limit(bool finalize, int maxIterations);

  /// Starts from rest.
  void begin();
  /// Starts from what a gesture like this one came to: first answers for what is dragged, while a run from rest goes on
  /// behind them, and then, if nobody overtakes it, the run from rest.
  void resume();
  /// One iteration, or a part of one; the last one ends with a result. Fails with `numericalFailure`, or with `badHandles` where the
  /// gesture would turn much of the shape inside out.
  Status step(StepReport& report);

  /// What is to be shown, #V×3: of a further attempt nothing until it has come as far.
  const Points& positions() const { return shown_; }
  /// Γ of each face, #F.
  const Scalars& sphericity() const { return first_->surface.sphericity; }
  /// What a person should know of the result, a sentence each.
  const std::vector<std::string>& remarks() const { return remarks_; }

 private:
  /// A surface with its two systems.
  struct Attempt {
    RestSurface surface;
    Structure structure;
    ReshapeTerms terms;
    VertexSystem vertices;
    TransformationSystem transformations;
    Alternation alternation;

    /// Takes other terms, and then the rows; `prepareNext` does what that asks for, slice by slice.
    void setTerms(const ReshapeTerms& wanted, const std::vector<bool>& keptPatches);
    void setRows(std::vector<PointRow> rows);
    Status prepareNext(double& share);
    /// Makes the run that comes one that depends on none before.
    void forgetRuns();
    void begin(const AlternationLimits& limits);

   private:
    bool areTransformationsReady_ = false, areVerticesReady_ = false;
  };

  void aimRows(const std::vector<Vec3>& targets);
  std::vector<Vec3> movesTo(const std::vector<Vec3>& targets) const;
  void show(const Points& positions);
  std::optional<Points> startOfGesture() const;
  void afterAnswer(StepReport& report);
  void stepBehind();
  void endDrag();
  void reset();
  void setRung(Rung rung);
  Status prepareAttempt();
  AlternationLimits limits() const;
  std::vector<bool> findKeptPatches(const Structure& structure) const;
  Status finish(Attempt& attempt);
  void repeat();
  void findSecondStructure();
  Status spread(Attempt& attempt);
  Status judge();
  double handleError(const Points& positions) const;

  RunSettings settings_;
  RunRows rows_;
  bool finalize_ = true;
  int maxIterations_ = 100;
  const RestSurface* rest_ = nullptr;
  std::vector<bool> keptPatches_;
  bool isAccelerated_ = true;
  Rung rung_ = Rung::full;
  std::unique_ptr<Attempt> first_;           // from the rest shape
  std::unique_ptr<Attempt> second_;          // from what the first came to, if it missed a handle
  std::unique_ptr<StructureSearch> search_;  // while the second is made
  bool isReady_ = false;                     // whether the present attempt may iterate
  std::optional<Points> resumed_;            // where it is to start
  RunBehind behind_;
  bool isDragged_ = false;      // whether answers come before the run from rest
  int answersLeft_ = 0;         // iterations of them
  bool isBehindsTurn_ = false;  // rather than the next answer's
  bool isDone_ = false;
  Outcome outcome_ = Outcome::running;
  Points result_;  // of the present rung
  Points best_;    // of those before
  FoldReport bestFolds_;
  bool hasBest_ = false;
  Points shown_;
  bool isShowing_ = true;                     // whether it follows the run
  std::vector<Vec3> targets_, shownTargets_;  // of the handles; of what is shown
  std::vector<std::string> remarks_;
};

}  // namespace whittle
