#pragma once

#include <memory>

#include "methods/local_global/local_global.h"
#include "methods/local_global/normal_driven/element_targets.h"
#include "targets/texture_normals.h"

namespace whittle {

struct NormalMapParameters {
  std::shared_ptr<const TextureSlopes> image;  // has to be given
  double strength = 1;                         // how many times as steep as the image
  double lambda = 10;                          // λ, Eq. 3, of all vertices
  Rigidity regularizer = Rigidity::acap;       // heights are details, and sizes may change for them (2021, §4.1)
  Scalars lambdaPerVertex;                     // λ of each vertex in its place, #V; or empty
  Handles handles;
  Planes planes;
  Parts parts = Parts::together;
  SolverParameters solver;
};

/// The local step of `normalmap` (2021, §6 and Fig. 22): every element is drawn to the normal that a texture has there,
/// so that what was an image on the surface becomes its shape. Targets are those of the rest shape; they do not follow
/// the output.
class NormalMapLocalStep : public TargetedLocalStep {
 public:
  using Parameters = NormalMapParameters;
  static EngineValues engineValues(const NormalMapParameters& values) {
    return {values.regularizer, values.handles, values.solver, values.parts, values.planes};
  }
  static Status check(const NormalMapParameters& values);
  static std::vector<std::string> warnings(const NormalMapParameters& values);

  void prepare(const RestShape& rest, const NormalMapParameters& values);
};

/// Registry line of the method `normalmap`.
MethodInfo normalmapMethod();

}  // namespace whittle
