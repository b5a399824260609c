#pragma once

#include <memory>

#include "methods/local_global/cubic_solver.h"
#include "methods/local_global/local_step.h"
#include "methods/local_global/polyhedron.h"
#include "methods/method.h"

namespace whittle {

/// The local step of Cubic Stylization (2019, §3.1): max_R tr(R M) − λ a |R n|₁ at every vertex, exactly or by the printed
/// ADMM. Without cubeness or without a normal it is the plain fit.
class CubicLocalStep : public LocalStep {
 public:
  Status prepare(const RestShape& rest, const Settings& settings) override;
  void begin() override { solver_->begin(weights_.size(), weights_); }
  Lanes fit(std::size_t batch, const ScaledCovariances& covariances, bool neverWorse, QuaternionLanes& rotations) override;

 private:
  std::vector<VectorLanes> normals_;  // of the rest shape, zero where there is none
  std::vector<VectorLanes> weights_;  // κ = λ a_i on each axis
  Polyhedron polyhedron_;
  std::unique_ptr<CubicSolver> solver_;
};

/// Registry line of the method `cubic`.
MethodInfo cubicMethod();

}  // namespace whittle
