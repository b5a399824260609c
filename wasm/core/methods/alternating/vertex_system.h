#pragma once

#include <vector>

#include "linear/sparse_cholesky.h"
#include "methods/alternating/reshape_energy.h"
#include "methods/alternating/vertex_blocks.h"

namespace whittle {

/// The vertex solve (§4.2, Eq. 20 to 23, 35): the positions that are best for given transformations, target lengths and
/// stresses. One linear system in 3#V unknowns whose matrix changes from iteration to iteration and whose pattern does
/// not: the Cholesky factor of the first is the preconditioner of all later ones, until they are too far from it.
class VertexSystem {
 public:
  /// @param surface to be kept by the caller
  /// @param rows what does not change but for its targets
  void shape(const RestSurface& surface, const EnergyWeights& weights, std::vector<PointRow> rows);
  std::vector<PointRow>& rows() { return rows_; }
  const std::vector<PointRow>& rows() const { return rows_; }

  /// The matrix and right-hand side for these goals.
  void assemble(const EdgeGoals& goals, const Transformations& transformations);
  /// The matrix of deformations that minimise Σ ‖e − ē‖² / L_avg alone, with the rows ("Poisson").
  void assemblePoisson();

  /// Begins to analyze and factor what is assembled; `prepareNext` does it slice by slice (`linear/slices.h`).
  void beginPrepare();
  Status prepareNext(double& share);
  /// Moves positions to the minimum. Fails with `numericalFailure` where numbers run away.
  /// @param tolerance of the residual, against that at the start
  Status solve(double tolerance, Points& positions);

 private:
  using Vector = Eigen::VectorXd;

  void addSphericity(Index face);
  void addRows();
  void addTargets();

  const RestSurface* surface_ = nullptr;
  EnergyWeights weights_;
  std::vector<PointRow> rows_;
  VertexBlocks blocks_;
  std::vector<double> constants_;  // the part of the values that never changes
  SparseMatrix matrix_;            // lower triangle
  Points rhs_;                     // #V×3
  Vector residual_, correction_;
  SparseCholesky cholesky_;
  enum class Stage { analyzing, factoring, done } stage_ = Stage::analyzing;
};

}  // namespace whittle
