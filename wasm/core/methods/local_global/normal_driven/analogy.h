#pragma once

#include <memory>

#include "methods/local_global/local_global.h"
#include "methods/local_global/normal_driven/element_targets.h"
#include "targets/gauss_map.h"
#include "targets/sphere_field.h"

namespace whittle {

struct AnalogyParameters {
  std::shared_ptr<const GaussMap> style;  // has to be given
  double lambda = 1;                      // λ, Eq. 3, of all vertices
  Rigidity regularizer = Rigidity::arap;
  bool dynamicTargets = false;                          // whether targets follow the output, §4.2
  Scalars lambdaPerVertex;                              // λ of each vertex in its place, #V; or empty
  std::shared_ptr<const SphereField> lambdaOnGaussMap;  // what of it normals of the rest shape have; or null: all
  Handles handles;
  Planes planes;
  Parts parts = Parts::together;
  SolverParameters solver;
};

/// The local step of Normal-Driven Spherical Shape Analogies (2021, Eq. 3 and §4.1): every element is drawn to the
/// target normal that the style's Gauss map has for it.
///
/// A vertex has a normal and a target for each of its smooth fans, so that the corner of a block is drawn to three faces
/// of the style and not to what lies on its diagonal. Targets are those of the rest shape's normals, or (dynamic, §4.2) of the output's, looked up anew in every
/// iteration.
class AnalogyLocalStep : public TargetedLocalStep {
 public:
  using Parameters = AnalogyParameters;
  static EngineValues engineValues(const AnalogyParameters& values) {
    return {values.regularizer, values.handles, values.solver, values.parts, values.planes};
  }
  static Status check(const AnalogyParameters& values);
  static std::vector<std::string> warnings(const AnalogyParameters&) { return {}; }

  void prepare(const RestShape& rest, const AnalogyParameters& values);
  bool followsOutput() const override { return isDynamic_; }
  bool keepsBest() const override { return isDynamic_; }
  void observe(const Points& positions) override;

 private:
  /// Looks the targets of the present normals up; what has no normal keeps the target that it has.
  void lookUpTargets();

  std::shared_ptr<const GaussMap> style_;
  const RestShape* rest_ = nullptr;
  Rigidity rigidity_ = Rigidity::arap;
  bool isDynamic_ = false;
  Points present_;   // normals that the targets are those of, #normals×3
  Scalars scratch_;  // #normals
};

/// Registry line of the method `analogy`.
MethodInfo analogyMethod();

}  // namespace whittle
