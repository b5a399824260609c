#pragma once

#include "methods/local_global/local_step.h"
#include "methods/method.h"

namespace whittle {

/// The local step of Cubic Stylization (2019, §3.1): max_R tr(R M) − λ a |R n|₁ at every vertex by scaled ADMM, warm from
/// the iteration before. Penalty and tolerances are scaled with the vertex area, so that fine meshes are solved as
/// far as coarse ones (the printed constants stop early there).
class CubicLocalStep : public LocalStep {
 public:
  void prepare(const RestShape& rest, const Settings& settings) override;
  void begin() override;
  double fit(const std::vector<Mat3>& covariances, std::vector<Mat3>& rotations) override;

 private:
  /// ADMM variables of a vertex: R n = z, scaled dual u, penalty ρ (Eqs. 4–7).
  struct Admm {
    Vec3 z;
    Vec3 u;
    double rho;
  };

  void solveVertex(const Mat3& M, const Vec3& n, double weight, Admm& state, Mat3& R) const;

  Scalars weights_;                  // #V, λ a_i
  const Points* normals_ = nullptr;  // #V×3, of the rest shape
  std::vector<Admm> admm_;
};

/// Registry line of the method `cubic`.
MethodInfo cubicMethod();

}  // namespace whittle
