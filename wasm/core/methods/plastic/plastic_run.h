#pragma once

#include <string>

#include "methods/method.h"
#include "methods/plastic/equilibrium.h"
#include "methods/plastic/landmark_step.h"
#include "methods/plastic/turn_path.h"

namespace whittle {

/// What a run is asked for. Lengths are those of a shape that is 100 long, see `PlasticRun`.
struct PlasticSettings {
  double alpha = 10;
  double beta = 0;
  double radius = 0.15;    // of influence, as a share of the length, where `isByRadius`
  bool isByRadius = true;  // whether the radius says how large β is
  double thickness = 10;
  double poisson = 0.3;
  bool resetsRest = true;  // whether each step starts from the shape of the one before, and not from the input's
  bool aligns = true;      // whether parts are first moved as they are, as far as held vertices let them
  double turn = 0;         // of the moved landmarks in all, radians; 0: the least
  int maxIterations = 20;
};

/// What is held and what is to go where, on a mesh.
struct LandmarkSet {
  std::vector<Index> fixed;
  std::vector<Landmark> moved;
};

/// Modelling by plasticity: Gauss–Newton steps over the plastic field of a shell, each with its static equilibrium, until
/// the landmarks are met.
///
/// The mesh is brought to a length of 100: √12 times the area's root mean square distance from its centre, which of a box
/// is the diagonal, and unlike that of the bounding box does not change when the mesh is turned. Parts of it that no
/// landmark moves stay out.
class PlasticRun {
 public:
  /// Takes a mesh without faces of no area; `prepareNext` prepares, slice by slice.
  void shape(const TriangleMesh& mesh, const LandmarkSet& landmarks, const PlasticSettings& settings);
  Status prepareNext(double& share);
  /// Other targets for the same landmarks, and how long to go on.
  void aim(const std::vector<Vec3>& targets, int maxIterations);

  void begin();
  /// An iteration, or a part of one.
  Status step(StepReport& report);

  /// Where the vertices of the mesh are, #V×3.
  const Points& positions() const { return shown_; }
  /// The mean distance of landmarks from their targets of the leg, in a shape that is 100 long, and the largest from those
  /// at its end.
  double meanError() const;
  double largestError() const;
  /// Whether the run ended because it had made all iterations that it may.
  bool isAtLimit() const { return outcome_ == Outcome::iterationLimit; }
  /// How many times as far apart as at rest two landmarks are to be, at most, held vertices among them.
  double demandedStretch() const;

 private:
  enum class Phase { start, assemble, factor, direction, trial, done };

  void takeActiveParts(const TriangleMesh& mesh, const LandmarkSet& landmarks);
  void align();
  void findPath();
  void goOn();
  void beginIteration(StepReport& report);
  void beginTrial();
  void judgeTrial(StepReport& report);
  void accept(StepReport& report);
  void show();
  void endLeg(Outcome outcome, StepReport& report);
  void finish(Outcome outcome);
  double squaredErrors(const Points& positions) const;
  double longestShare(const Scalars& change) const;

  PlasticSettings settings_;
  Points input_;                 // of the mesh
  std::vector<Index> vertices_;  // of the mesh, by vertex of the shell
  double scale_ = 1;             // from the mesh to the shell
  Vec3 center_ = Vec3::Zero();
  TriangleMesh active_;  // at rest
  std::vector<Index> nodeOf_;
  std::vector<Landmark> landmarks_;  // with the targets of the leg
  std::vector<Vec3> targets_;
  TurnPath path_;
  int leg_ = 1, iterationsOfLeg_ = 0;
  Components parts_;

  Shell shell_;
  ShellSystem system_;
  PlasticPrior prior_;
  RigidModes modes_;
  LandmarkStep direction_;
  Equilibrium equilibrium_;

  bool isAnalyzed_ = false;
  Phase phase_ = Phase::done;
  Outcome outcome_ = Outcome::converged;
  int iterations_ = 0;
  Points positions_;  // of the shell
  PlasticField field_;
  Scalars change_;  // what of it the prior keeps
  double objective_ = 0;
  double share_ = 1;  // of the step that is tried
  int halvings_ = 0;
  PlasticField trialField_;
  Points shown_;
};

}  // namespace whittle
