#pragma once

#include <memory>

#include "methods/local_global/cubic_vertex.h"
#include "methods/local_global/local_step.h"
#include "methods/method.h"

namespace whittle {

/// The local step of Cubic Stylization (2019, §3.1): max_R tr(R M) − λ a |R n|₁ at every vertex, exactly or by the printed
/// ADMM. Without cubeness or without a normal it is the plain fit.
class CubicLocalStep : public LocalStep {
 public:
  void prepare(const RestShape& rest, const Settings& settings) override;
  void begin() override { solver_->begin(weights_); }
  double fit(const std::vector<Mat3>& covariances, const std::vector<Mat3>& guess, bool neverWorse,
             std::vector<Mat3>& rotations) override;

 private:
  Scalars weights_;                  // #V, λ a_i
  const Points* normals_ = nullptr;  // #V×3, of the rest shape
  std::unique_ptr<CubicVertexSolver> solver_;
};

/// Registry line of the method `cubic`.
MethodInfo cubicMethod();

}  // namespace whittle
