#pragma once

#include "methods/local_global/local_global.h"
#include "methods/local_global/normal_driven/developable_normals.h"
#include "methods/local_global/normal_driven/element_targets.h"

namespace whittle {

struct DevelopableParameters {
  double lambda = 20;       // λ, Eq. 3, of all vertices
  double creases = 0.65;    // share of the vertices that may become creases
  Scalars lambdaPerVertex;  // λ of each vertex in its place, #V; or empty
  Handles handles;
  Planes planes;
  Parts parts = Parts::together;
  int maxIterations = 150;  // targets follow the output, so that nothing else says when to stop
};

/// The local step of developable surface approximation (2021, §5.2, App. E): every face is drawn to the normal that the
/// rings around it propose, looked up from the output in every iteration, while triangles keep their shape and edges
/// between them bend freely (FARAP).
class DevelopableLocalStep : public TargetedLocalStep {
 public:
  using Parameters = DevelopableParameters;
  static EngineValues engineValues(const DevelopableParameters& values);
  static Status check(const DevelopableParameters&) { return {}; }
  static std::vector<std::string> warnings(const DevelopableParameters&) { return {}; }

  void prepare(const RestShape& rest, const DevelopableParameters& values);
  bool followsOutput() const override { return true; }
  void observe(const Points& positions) override;

 private:
  DevelopableNormals normals_;
};

/// Registry line of the method `developable`.
MethodInfo developableMethod();

}  // namespace whittle
