#pragma once

#include "methods/local_global/cubic/cubic_solver.h"
#include "methods/local_global/cubic/polyhedron.h"

namespace whittle {

/// The printed local step (2019, §3.1 and, for polyhedra, §4): scaled ADMM. Penalty and tolerances are scaled with the
/// vertex area, so that fine meshes are solved as far as coarse ones (the printed constants stop early there).
class CubicAdmm : public CubicSolver {
 public:
  struct Tolerances {
    double primal = 1e-5;    // ε_abs of the printed method, on R n and z (of unit length)
    double dual = 1e-3;      // ε_abs for the dual residual, as a share of λ a
    double relative = 1e-3;  // ε_rel
    int maxSteps = 100;
  };

  explicit CubicAdmm(const Polyhedron& polyhedron) : polyhedron_(polyhedron) {}
  CubicAdmm(const Polyhedron& polyhedron, const Tolerances& tolerances)
      : polyhedron_(polyhedron), tolerances_(tolerances) {}

  void begin(const FanLayout& layout) override;
  Lanes solve(std::size_t batch, const CubicLanes& vertices, QuaternionLanes& rotations) override;

  /// R n = z, scaled dual u, penalty ρ as a multiple of κ (Eqs. 4–7); a z and a u for each normal, and the first's ρ for
  /// all.
  struct State {
    Vec3 z = Vec3::Zero();
    Vec3 u = Vec3::Zero();
    double rho = 5;
  };

  /// One vertex in double precision from a rotation R, which is updated.
  /// @param states of the normals
  void solve(const Mat3& M, FanNormals normals, std::span<State> states, Mat3& R) const;

 private:
  /// Minimises for z and u of all normals; returns whether both residuals are within their tolerances.
  bool updateDuals(FanNormals normals, std::span<State> states, const Mat3& R) const;

  Polyhedron polyhedron_;
  Tolerances tolerances_;
  const FanLayout* layout_ = nullptr;
  std::vector<State> states_;       // of one vertex after the other, as many for each as its batch has normals
  std::vector<FanNormal> normals_;  // scratch
};

}  // namespace whittle
