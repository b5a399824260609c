#pragma once

#include <vector>

#include "methods/local_global/cubic_vertex.h"

namespace whittle {

/// The printed local step (2019, §3.1): scaled ADMM. Penalty and tolerances are scaled with the vertex area, so that fine
/// meshes are solved as far as coarse ones (the printed constants stop early there).
class CubicAdmm : public CubicVertexSolver {
 public:
  struct Tolerances {
    double primal = 1e-5;    // ε_abs of the printed method, on R n and z (of unit length)
    double dual = 1e-3;      // ε_abs for the dual residual, as a share of λ a
    double relative = 1e-3;  // ε_rel
    int maxSteps = 100;
  };

  CubicAdmm() = default;
  explicit CubicAdmm(const Tolerances& tolerances) : tolerances_(tolerances) {}

  void begin(const Scalars& weights) override;
  void solve(Index vertex, const Mat3& M, const Vec3& n, double weight, Mat3& R) override;

 private:
  /// R n = z, scaled dual u, penalty ρ (Eqs. 4–7).
  struct State {
    Vec3 z;
    Vec3 u;
    double rho;
  };

  Tolerances tolerances_;
  std::vector<State> states_;
};

}  // namespace whittle
