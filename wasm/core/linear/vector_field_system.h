#pragma once

#include <array>
#include <vector>

#include "base/status.h"
#include "linear/lane_gradients.h"
#include "linear/sparse_cholesky.h"

namespace whittle {

/// A symmetric positive definite system whose unknowns are vectors in space, one a node, with a 3×3 block for each node
/// and each coupled pair. Values change often, the pattern does not. Solved by conjugate gradients in single precision
/// with the Cholesky factor of the mean of the x, y and z parts for preconditioner: a ninth of the numbers that a factor
/// of all unknowns has, and x, y and z share every pass over it.
class VectorFieldSystem {
 public:
  /// @param pairs nodes that are coupled, the smaller first, rising, each once
  void shape(Index nodes, std::vector<std::array<Index, 2>> pairs);
  Index size() const { return static_cast<Index>(diagonal_.size()); }
  Index pairCount() const { return static_cast<Index>(pairs_.size()); }
  /// The place of a pair among the pairs.
  Index findPair(Index low, Index high) const;

  /// The values: a symmetric block for each node, and for each pair that of the larger node's rows and the smaller
  /// one's columns.
  std::vector<Mat3>& diagonal() { return diagonal_; }
  std::vector<Mat3>& couplings() { return couplings_; }

  /// Begins to analyze and factor the preconditioner for the present values; `prepareNext` does it slice by slice
  /// (`slices.h`).
  /// @param coordinates #nodes×3, to be kept by the caller until then
  void beginPrepare(const Points& coordinates);
  Status prepareNext(double& share);

  /// Begins a row of solves that depends on none before: values that were solved for in between are forgotten. Returns
  /// whether that is done; else `prepareNext` brings the preconditioner back that was prepared.
  bool beginAnew();

  /// Begins to move X (#nodes×3) nearer to the solution of A X = B; `improveNext` does it. Neither allocates, but where
  /// the present values have left the preconditioner behind and it is taken anew. B and X are kept by the caller until
  /// the end.
  /// @param tolerance share of what is left that may remain
  void beginImprove(const Points& B, double tolerance, int iterations, Points& X);
  /// Does a slice of some 20 ms; X is what it was until the end. Fails with `numericalFailure` if A is not positive
  /// definite.
  Status improveNext(bool& isDone);

 private:
  /// A neighbour of a node.
  struct Neighbour {
    Index node;
    Index pair;
    bool isLower;  // whether it is the smaller node of the pair
  };

  void subtractProduct(const Points& X);
  void toSingle();
  /// y = A x; returns xᵀ y.
  double apply(const LaneRows& x, LaneRows& y) const;
  double precondition(const LaneRows& r, LaneRows& z);
  void average();
  void beginDescent();

  std::vector<std::array<Index, 2>> pairs_;
  std::vector<Mat3> diagonal_, couplings_;
  std::vector<Index> start_;  // #nodes + 1, into `neighbours_`
  std::vector<Neighbour> neighbours_;

  LaneRows
      blocks_;  // in single precision, of each node the sum of its row and then the blocks to its neighbours, by columns
  // While X is improved
  const Points* rhs_ = nullptr;
  Points* X_ = nullptr;
  double tolerance_ = 0, first_ = 0;  // rᵀ M⁻¹ r at the start
  double scale_ = 0;                  // of that, what the tolerance is a share of
  int left_ = 0, most_ = 0;
  bool isFresh_ = false, isRefreshing_ = false;  // whether the preconditioner is of these values, or on its way
  Points residual_;
  LaneRows rows_, correction_;  // #nodes + 1, the last one spare
  LaneGradients gradients_;

  SparseMatrix mean_;     // lower triangle
  Scalars preparedMean_;  // its entries when it was prepared
  bool isLeft_ = false;   // whether the preconditioner is of other values than these
  SparseCholesky cholesky_;
  enum class Stage { analyzing, factoring, done } stage_ = Stage::analyzing;
};

}  // namespace whittle
