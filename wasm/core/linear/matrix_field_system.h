#pragma once

#include <vector>

#include "base/status.h"
#include "linear/graph.h"
#include "linear/lane_gradients.h"
#include "simd/lanes.h"

namespace whittle {

/// 3×3 matrices in single precision, one a node: each is three rows of lanes, its columns.
using MatrixRows = LaneRows;

/// A symmetric positive definite system whose unknowns are 3×3 matrices X, one for each node of a graph:
///
///     (A X)_t = D_t X_t − Σ_s X_s P_ts      D_t 9×9 on the columns of X_t, P_ts = P_st symmetric 3×3
///
/// Nodes are coupled row by row, within a node everything may be. Solved by conjugate gradients with the inverses of
/// the D_t for preconditioner, in single precision: for callers that solve for a correction of what they have.
class MatrixFieldSystem {
 public:
  using Block = Eigen::Matrix<double, 9, 9>;

  struct Limits {
    double residual = 1e-4;  // ‖r‖ / ‖b‖ of the caller's right-hand side, both in the norm of the preconditioner
    int iterations = 60;
  };

  /// Claims what a graph of nodes needs. All couplings are zero then.
  void shape(Graph graph);
  const Graph& graph() const { return graph_; }
  Index size() const { return graph_.size(); }

  /// Sets D_t, once the node's couplings are there. Fails with `numericalFailure` if it is not positive definite.
  Status setDiagonal(Index node, const Block& block);
  /// Sets P of a node and its neighbour at this place of `graph().neighbours`.
  void setCoupling(Index place, const Mat3& P);

  /// ‖b‖ in the norm of the preconditioner, squared: what `Limits::residual` refers to.
  double squaredNorm(const MatrixRows& b) const;

  /// Begins to make of a residual the correction X that A X = residual; `solveNext` does it. Neither allocates. Both
  /// are kept by the caller until the end.
  /// @param residual 3 #nodes rows, overwritten
  /// @param squaredScale ‖b‖² of what the residual is a share of
  /// @param correction 3 #nodes rows, out
  void beginSolve(MatrixRows& residual, double squaredScale, const Limits& limits, MatrixRows& correction);
  /// Does a slice of some 20 ms; returns whether all is done.
  bool solveNext();

 private:
  static constexpr std::size_t kBlockSize = 81;
  struct Coupling {
    float xx, xy, xz, yy, yz, zz;
  };

  /// y = A x; returns xᵀ y.
  double apply(const MatrixRows& x, MatrixRows& y) const;
  /// z = M⁻¹ r; returns rᵀ z.
  double precondition(const MatrixRows& r, MatrixRows& z) const;

  Graph graph_;
  /// D_t − I ⊗ Σ P of each node, column after column: couplings take what they are of X_t themselves.
  std::vector<float> diagonal_;
  std::vector<float> inverse_;       // of D_t
  std::vector<Coupling> couplings_;  // one for each place of `neighbours`

  // While a solve goes on
  LaneGradients gradients_;
  MatrixRows* residual_ = nullptr;
  MatrixRows* correction_ = nullptr;
  double small_ = 0;
  int left_ = 0;
};

}  // namespace whittle
