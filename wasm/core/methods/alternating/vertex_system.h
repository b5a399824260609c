#pragma once

#include <vector>

#include "linear/vector_field_system.h"
#include "methods/alternating/reshape_energy.h"

namespace whittle {

/// The vertex solve (§4.2, Eq. 20 to 23, 35): the positions that are best for given transformations, target lengths and
/// stresses. One linear system in #V points whose matrix changes from iteration to iteration and whose pattern does
/// not: the factor of the first is the preconditioner of all later ones, until they are too far from it.
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
  void beginPrepare() { system_.beginPrepare(surface_->mesh.positions); }
  Status prepareNext(double& share) { return system_.prepareNext(share); }
  /// Begins a run that depends on none before; false where `prepareNext` has something to do for it.
  bool beginRun() { return system_.beginAnew(); }
  /// Begins to move positions, which the caller keeps, to the minimum, all but a share `tolerance` of what is left;
  /// `solveNext` does it slice by slice. Fails with `numericalFailure`.
  void beginSolve(double tolerance, Points& positions);
  Status solveNext(bool& isDone) { return system_.improveNext(isDone); }
  /// Does it in one go.
  Status solve(double tolerance, Points& positions);

 private:
  void addSphericity(Index face);
  void addRow(const PointRow& row, std::vector<Mat3>& diagonal, std::vector<Mat3>& couplings) const;
  void addLines(const EdgeGoals& goals);
  void addTargets();
  void restart();
  /// Adds the block of rows of vertex v and columns of w, and its transpose for w and v, to values by node and by pair.
  void add(Index v, Index w, const Mat3& block, std::vector<Mat3>& diagonal, std::vector<Mat3>& couplings) const;
  /// Adds K (e·e) of an edge to the present values.
  void addEdge(Index edge, const Mat3& K);

  const RestSurface* surface_ = nullptr;
  EnergyWeights weights_;
  std::vector<PointRow> rows_;
  VectorFieldSystem system_;
  std::vector<Index> pairOf_;               // #E, of each edge among the system's pairs
  std::vector<Mat3> diagonal_, couplings_;  // the part of the values that never changes
  Points rhs_;                              // #V×3
};

}  // namespace whittle
