#pragma once

#include "methods/local_global/normal_driven/developable_normals.h"
#include "methods/local_global/normal_driven/element_targets.h"
#include "methods/method.h"

namespace whittle {

/// The local step of developable surface approximation (2021, §5.2, App. E): every face is drawn to the normal that the rings around it propose,
/// looked up from the output in every iteration, while triangles keep their shape and edges between them bend freely (FARAP).
class DevelopableLocalStep : public TargetedLocalStep {
 public:
  Rigidity rigidity(const Settings&) const override { return Rigidity::farap; }
  Status prepare(const RestShape& rest, const Settings& settings) override;
  bool followsOutput() const override { return true; }
  void observe(const Points& positions) override;

 private:
  DevelopableNormals normals_;
};

/// Registry line of the method `developable`.
MethodInfo developableMethod();

}  // namespace whittle
