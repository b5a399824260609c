#pragma once

#include <vector>

#include "linear/row_planes.h"
#include "linear/sparse_cholesky.h"

namespace whittle {

/// What elimination of all other rows leaves: S in the rows that are held on planes, here in the free coordinates of
/// each, K = Tᵀ (S ⊗ I₃) T with the free axes of the rows in T. Axes of rows that are perpendicular couple nothing, so
/// with planes across the axes of space K falls into independent systems, one for each coordinate.
class PlaneSystem {
 public:
  /// @param rows that have freedom left
  explicit PlaneSystem(std::vector<HeldRow> rows) : rows_(std::move(rows)) {}

  /// @param schur S, lower triangle, in the order of the rows
  void beginPrepare(const SparseMatrix& schur);
  Status prepareNext(double& share, double work);

  /// Replaces what stands in the held rows, right-hand sides, by the solutions.
  void solve(LaneRow* rows);

 private:
  std::vector<HeldRow> rows_;
  std::vector<Index> start_;  // first unknown of each row
  SparseMatrix matrix_;       // K, until it is factored
  bool isAnalyzed_ = false;
  SparseCholesky cholesky_;
  LaneRows unknowns_;  // their numbers stand in x
};

}  // namespace whittle
