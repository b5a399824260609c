#pragma once

#include <optional>
#include <utility>

#include "methods/plastic/landmark_derivative.h"
#include "methods/plastic/plastic_prior.h"
#include "optimization/constrained_descent.h"
#include "optimization/dual_gauss_newton.h"

namespace whittle {

/// The Gauss–Newton step of a shell at rest under what is plastic about it, towards its landmarks: the change of the
/// plastic field and of the shape that goes with it, to first order. Slice by slice.
///
/// It is solved in the landmarks' coordinates. Of few landmarks J A⁻¹ Jᵀ is made as a whole; of many only the columns of
/// some that lie far apart, which precondition conjugate gradients for all.
class LandmarkStep {
 public:
  using Rows = PlasticPrior::Rows;

  struct Problem {
    const Shell& shell;
    const RigidModes& modes;
    const std::vector<Landmark>& landmarks;
    const Scalars& field;  // plastic change since what the prior keeps, 6 #F
  };

  /// Begins. The system must hold the factor of the shell in this shape; all is kept by the caller until the end.
  void begin(const Problem& problem, ShellSystem& system, PlasticPrior& prior);
  /// Does a slice. Fails with `numericalFailure`.
  Status next(bool& isDone);

  /// The change of the field, 6 #F.
  const Scalars& change() const { return change_; }
  /// Positions change by this, #V×3, without the rigid modes,
  const Points& move() const { return move_; }
  /// whose amounts stand here.
  const Scalars& rigid() const { return rigid_; }
  /// What the linear model says that is left: squared distances, and the price of the field.
  double model() const { return model_; }

 private:
  enum class Stage { derivative, offset, transposed, kept, images, descent, field, move, done };

  bool isWhole() const { return known_.size() == problem_->landmarks.size(); }
  void choose();
  Status advance();
  void go(Stage next);
  /// Whether the work of the stage, or of its part, is to be begun.
  bool begins() { return !std::exchange(isBegun_, true); }
  Status findTarget(bool& isReady);
  Status findTransposed(bool& isReady);
  Status findImages(bool& isReady);
  Status findMove(bool& isReady);
  void setTarget();
  void setImages();
  Status solveWhole(bool& isReady);
  void beginDescent();
  void takeField(const Rows& field);
  Status descend();

  std::optional<Problem> problem_;
  PlasticPrior* prior_ = nullptr;
  ShellSystem* system_ = nullptr;
  Stage stage_ = Stage::done;
  bool isBegun_ = false;  // the work of the stage
  int part_ = 0;          // of a product by J A⁻¹ Jᵀ
  LandmarkDerivative derivative_;
  std::vector<Index> known_;  // landmarks whose columns are made
  Rows selection_;            // #rows×3 #known
  Rows kept_;                 // A⁻¹ Jᵀ of the known ones, and growth
  Rows transposed_;           // Jᵀ of them
  Rows column_, combination_;
  Eigen::MatrixXd G_, images_;
  Scalars target_;
  LowRankInverse inverse_;
  ConstrainedDescent descent_;
  DualStep dual_;
  Points forces_, move_;
  Scalars change_, rigid_;
  double model_ = 0;
};

}  // namespace whittle
