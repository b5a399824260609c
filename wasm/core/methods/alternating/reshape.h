#pragma once

#include "methods/alternating/poisson.h"
#include "methods/alternating/reshape_run.h"
#include "methods/alternating/working_surface.h"
#include "methods/local_global/arap.h"
#include "methods/local_global/local_global_method.h"

namespace whittle {

/// Slippage-preserving reshaping (2023) and what people compare it with: handles move, and of the rest one or the other
/// is kept. The variants of the paper and Poisson deformation work on a surface of their own (`WorkingSurface`); as rigid
/// and as conformal as possible are those of the method `arap`.
class Reshape final : public MethodOf<ReshapeParameters> {
 public:
  Status check(const ReshapeParameters& values) const override;
  std::vector<Stage> plan(const TriangleMesh& rest, const ReshapeParameters& values, Stale stale) override;
  /// Starts from rest, or from what a run of a gesture like this one came to: the gesture's share of that.
  void begin(Points& positions) override;
  Status step(Points& positions, StepReport& report) override;
  std::vector<std::string> warnings(const ReshapeParameters& values) const override;
  std::vector<Field> fields() const override;

 private:
  bool isLocalGlobal() const { return variant_ == Variant::arap || variant_ == Variant::conformal; }
  void planLocalGlobal(const TriangleMesh& rest, const ReshapeParameters& values, Stale stale, Plan& plan);
  ArapParameters arapValues(const ReshapeParameters& values) const;
  void shape(const ReshapeParameters& values);
  void aim(const ReshapeParameters& values);
  std::vector<PointRow> otherRows(const ReshapeParameters& values, const std::vector<PointRow>& handles) const;
  std::vector<PointRow> aimed(const ReshapeParameters& values) const;
  void setGesture();
  /// Faces of the file that turn over while the surface that they follow does not.
  Index turnedOnTheWayBack() const;

  const TriangleMesh* rest_ = nullptr;
  Variant variant_ = Variant::slippage;
  WorkingSurface working_;
  ReshapeRun run_;
  PoissonRun poisson_;
  LocalGlobalMethod<ArapLocalStep> arap_;
  ArapParameters arapValues_;

  Handles handles_;
  std::vector<bool> keptWalls_;
  std::vector<std::string> straightRemarks_;
  bool isGesture_ = false;   // whether a handle is to move
  Points emitted_;           // the positions that the last step left, of the input
  Points workingPositions_;  // those of the working mesh that they came from
};

/// Registry line of the method `reshape`.
MethodInfo reshapeMethod();

}  // namespace whittle
