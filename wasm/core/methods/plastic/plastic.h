#pragma once

#include "constraints/handles.h"
#include "methods/plastic/plastic_run.h"
#include "remeshing/clean.h"
#include "remeshing/transfer.h"

namespace whittle {

struct PlasticParameters {
  Handles landmarks;
  double radius = 0.15;  // of influence, as a share of the shape's length; from 1 on all of a part
  double beta = 0;       // > 0: that instead of the radius
  double alpha = 10;
  double thickness = 10;  // of a shape that is 100 long
  double poisson = 0.3;
  bool resetRest = true;
  bool align = true;
  double turn = 0;  // of the moved landmarks in all, degrees; 0: the least
  int maxIterations = 20;
};

/// Large-strain surface modelling by plasticity (2023): landmarks are met by bending and stretching the surface lastingly
/// and smoothly. A landmark whose target is its own place is held there.
class Plastic final : public MethodOf<PlasticParameters> {
 public:
  Status check(const PlasticParameters& values) const override;
  std::vector<Stage> plan(const TriangleMesh& rest, const PlasticParameters& values, Stale stale) override;
  void begin(Points& positions) override;
  Status step(Points& positions, StepReport& report) override;
  std::vector<std::string> warnings(const PlasticParameters& values) const override;

 private:
  void findSurface();
  LandmarkSet landmarksOf(const PlasticParameters& values) const;
  PlasticSettings settingsOf(const PlasticParameters& values) const;
  void shape(const PlasticParameters& values);
  void aim(const PlasticParameters& values);
  /// Whether a vertex moves with the surface; without faces it moves as a landmark only.
  bool carries(Index vertex) const;
  bool isFixed(const Handles& landmarks, std::size_t which) const;

  const TriangleMesh* rest_ = nullptr;
  CleanMesh working_;
  std::optional<Transfer> transfer_;
  PlasticRun run_;
  std::vector<bool> shapedFixed_;  // which of the landmarks the run holds
  Handles landmarks_;
  bool isRadiusCapped_ = false;
};

/// Registry line of the method `plastic`.
MethodInfo plasticMethod();

}  // namespace whittle
