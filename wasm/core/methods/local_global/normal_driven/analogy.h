#pragma once

#include <memory>

#include "methods/local_global/normal_driven/element_targets.h"
#include "methods/method.h"

namespace whittle {

/// The local step of Normal-Driven Spherical Shape Analogies (2021, Eq. 3 and §4.1): every element is drawn to the target normal that the
/// style's Gauss map has for it.
///
/// Targets are those of the rest shape's normals, or (dynamic, §4.2) of the output's, looked up anew in every iteration.
class AnalogyLocalStep : public TargetedLocalStep {
 public:
  Rigidity rigidity(const Settings& settings) const override;
  Status prepare(const RestShape& rest, const Settings& settings) override;
  bool followsOutput() const override { return isDynamic_; }
  void observe(const Points& positions) override;

 private:
  /// Looks the targets of the present normals up; what has no normal keeps the target that it has.
  void lookUpTargets();

  std::shared_ptr<const GaussMap> style_;
  const Triangles* triangles_ = nullptr;
  Rigidity rigidity_ = Rigidity::arap;
  bool isDynamic_ = false;
  Points present_;   // normals that the targets are those of, #elements×3
  Scalars scratch_;  // #V
};

/// Registry line of the method `analogy`.
MethodInfo analogyMethod();

}  // namespace whittle
