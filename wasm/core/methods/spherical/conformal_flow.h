#pragma once

#include <optional>

#include "linear/sparse_cholesky.h"
#include "methods/method.h"
#include "methods/spherical/midpoint_refinement.h"

namespace whittle {

struct SphericalParameters {
  double timeStep = 1e-3;   // τ of the first step, for a surface of area 1
  double tolerance = 1e-9;  // mean squared move of a step as a share of the area
  int maxIterations = 300;
};

/// Conformalized mean curvature flow (Kazhdan et al. 2012) of a closed surface of genus 0 to a sphere, the map by which
/// a style mesh gives its normals to the unit sphere (2021, §3.1). One step solves
///
///     (M(U) + τ L₀) U⁺ = M(U) U
///
/// with M the lumped barycentric areas of the current surface and L₀ the cotangent Laplacian of the input; τ is that of
/// a surface of area 1, so it means the same for every mesh, and grows to its tenfold on the way. The surface keeps the
/// input's area and area centroid: a page can show it flowing.
///
/// The spheres that it can end at differ by Möbius transformations, along which it goes on drifting. So these do not
/// count as movement when it stops, and of all of them the result is the one in which the input's area is balanced
/// around the centre. Converged, it is a sphere of the input's area around the input's area centroid, every vertex on
/// it and no triangle folded over; whoever needs points of the unit sphere takes the directions from the centroid. A
/// run that the iteration limit ends leaves the surface as it is.
///
/// A mesh of few vertices flows as a finer one of the same shape: lumped areas at the eight corners of a box cannot tell a
/// sphere from an ellipsoid, and the flow draws them out to a needle.
///
/// The energy that is reported is Dirichlet's over the area: at least 1, and 1 only where the map keeps angles. Each
/// step factors a matrix anew and allocates for it.
class ConformalFlow : public MethodOf<SphericalParameters> {
 public:
  /// @param rest a mesh that `requireSphere` lets through
  std::vector<Stage> plan(const TriangleMesh& rest, const SphericalParameters& values, Stale stale) override;
  void begin(Points& positions) override;
  /// Fails with `numericalFailure` where the flow loses its numbers, ends folded or leaves the input's size behind; the
  /// positions are then those before.
  Status step(Points& positions, StepReport& report) override;

 private:
  void measure(const TriangleMesh& rest);
  Status stepSurface(Points& positions, StepReport& report);
  /// Whether the surface is drawn out of all proportion to the input.
  bool isDrawnOut(const Points& positions) const;
  /// Moves the surface by one solve; `area` is its area before.
  Status flow(Points& positions, double area);
  /// The time step of this iteration.
  double timeStep() const;
  /// Scales and moves the surface to the rest shape's area and area centroid.
  void restoreFrame(Points& positions) const;
  /// Mean squared move since `previous_` as a share of the area, Möbius transformations apart: the stopping measure.
  double meanSquaredMove(const Points& positions, double area);
  /// Rounds the surface to the balanced sphere. Fails if that is folded.
  Status project(Points& positions) const;

  SphericalParameters values_;

  // Prepared once per mesh
  const TriangleMesh* input_ = nullptr;
  std::optional<MidpointRefinement> refinement_;  // of an input of few vertices
  const TriangleMesh* rest_ = nullptr;            // what flows: the input or its refinement
  double restArea_ = 0;
  Vec3 restCentroid_ = Vec3::Zero();
  SparseMatrix laplacian_;  // L₀, lower triangle
  SparseMatrix system_;     // M + τ L₀, lower triangle
  SparseCholesky cholesky_;

  // Running state
  int iterations_ = 0;
  Points surface_;     // of the refinement
  Scalars areas_;      // #V, M
  Points gradient_;    // #V×3, L₀ U; then the directions from the centroid
  Points correction_;  // #V×3; then the move
  Points previous_;
};

/// Registry line of the method `spherical`.
MethodInfo sphericalMethod();

}  // namespace whittle
