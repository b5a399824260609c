#pragma once

#include "methods/local_global/normal_driven/element_targets.h"
#include "methods/method.h"

namespace whittle {

/// The local step of `normalmap` (2021, §6 and Fig. 22): every element is drawn to the normal that a texture has there, so that what
/// was a picture on the surface becomes its shape. Targets are those of the rest shape; they do not follow the output.
class NormalMapLocalStep : public TargetedLocalStep {
 public:
  Rigidity rigidity(const Settings& settings) const override;
  Status prepare(const RestShape& rest, const Settings& settings) override;
};

/// Registry line of the method `normalmap`.
MethodInfo normalmapMethod();

}  // namespace whittle
