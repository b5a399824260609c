#pragma once

#include <optional>

#include "methods/plastic/plastic_prior.h"
#include "methods/plastic/sensitivity.h"
#include "methods/plastic/shell_system.h"

namespace whittle {

/// A point of the surface that is to come to a place: weights on up to three vertices.
struct Landmark {
  std::array<Index, 3> vertices = {-1, -1, -1};
  Vec3 weights = Vec3::Zero();
  Vec3 target = Vec3::Zero();

  Vec3 at(const Points& positions) const;
};

/// The Gauss–Newton step of a shell at rest under what is plastic about it, towards its landmarks: the change of the
/// plastic field and of the shape that goes with it, to first order. Slice by slice.
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
  /// That of the positions, #V×3, without
  const Points& move() const { return move_; }
  /// the amounts of the rigid modes.
  const Scalars& rigid() const { return rigid_; }
  /// What the linear model says that is left: squared distances, and the price of the field.
  double model() const { return model_; }

 private:
  enum class Stage { compliance, sensitivities, prior, dual, predictor, done };

  void setLoads(Index first, Index count);
  void takeSolutions(Index first);
  void findSensitivities();
  Status solveForField();
  Status predict();

  std::optional<Problem> problem_;
  ShellSystem* system_ = nullptr;
  PlasticPrior* prior_ = nullptr;
  Stage stage_ = Stage::done;
  Index next_ = 0;
  Rows batch_, compliance_;  // 3 #V×#rows: Y = K⁻¹ Cᵀ
  Sensitivity sensitivity_;
  Rows transposed_, kept_;  // Jᵀ and W = A⁻¹ Jᵀ, 6 #F×#rows
  Points forces_, move_;
  Scalars change_, rigid_;
  double model_ = 0;
};

}  // namespace whittle
