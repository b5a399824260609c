#pragma once

#include <memory>

#include "methods/local_global/cubic/cubic_solver.h"
#include "methods/local_global/cubic/polyhedron.h"
#include "methods/local_global/cubic/style_frames.h"
#include "methods/local_global/local_global.h"
#include "methods/values/choice_or_rows.h"
#include "targets/sphere_field.h"

namespace whittle {

/// How the cubic local step is solved.
enum class CubicSolverKind { exact, admm };

struct CubicParameters {
  double lambda = 0.2;                                  // λ, Eq. 1: cubeness of all vertices
  Scalars lambdaPerVertex;                              // λ of each vertex in its place, #V; or empty
  std::shared_ptr<const SphereField> lambdaOnGaussMap;  // what of it normals of the rest shape have; or null: all
  Vec3 lambdaAxes = Vec3::Ones();                       // what the cube takes λ times on each axis
  NameOrRows<Polyhedron::Name> polyhedron;              // B, §4
  Quaternion orientation = kIdentityQuaternion;         // Q of all vertices
  Quaternions frames;                                   // Q of single vertices, #V×4; or empty
  CubicSolverKind localStep = CubicSolverKind::exact;
  Handles handles;
  Planes planes;
  Parts parts = Parts::together;
  SolverParameters solver;
};

/// The local step of Cubic Stylization (2019, §3.1 and §4): max_R tr(R M) − λ a |B Qᵀ R n|₁ at every vertex, exactly or
/// by the printed ADMM, with B the cube, a box of other weights on each axis or any polyhedron, and a frame Q. A vertex
/// on a sharp edge has a term like this for each of its smooth fans, whose areas a add up to its own. Without cubeness
/// or without a normal it is the plain fit.
class CubicLocalStep : public LocalStep {
 public:
  using Parameters = CubicParameters;
  static EngineValues engineValues(const CubicParameters& values) {
    return {Rigidity::arap, values.handles, values.solver, values.parts, values.planes};
  }
  /// Fails with `badParameter` where axes of different weight meet a polyhedron that has no axes.
  static Status check(const CubicParameters& values);
  static std::vector<std::string> warnings(const CubicParameters& values);

  void prepare(const RestShape& rest, const CubicParameters& values);
  void begin() override { solver_->begin(layout_); }
  Lanes fit(std::size_t batch, const MatrixLanes& covariances, bool neverWorse, QuaternionLanes& rotations) override;

 private:
  void prepareVertices(const RestShape& rest, const CubicParameters& values);
  void prepareStyle(const CubicParameters& values);
  /// The step in the vertices' frames.
  Lanes solve(std::size_t batch, const MatrixLanes& M, bool neverWorse, QuaternionLanes& rotations);
  /// Goes back to the guess in lanes where it is better.
  void keepBetter(const CubicLanes& vertices, const QuaternionLanes& guess, QuaternionLanes& rotations,
                  Lanes& regularizers);

  FanLayout layout_;
  std::vector<FanLanes> fans_;      // of the rest shape, by slot; without a normal where there is none
  std::vector<FanNormal> normals_;  // scratch
  Polyhedron polyhedron_;
  StyleFrames frames_;
  std::unique_ptr<CubicSolver> solver_;
};

/// Registry line of the method `cubic`.
MethodInfo cubicMethod();

}  // namespace whittle
