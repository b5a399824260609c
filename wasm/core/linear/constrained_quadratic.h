#pragma once

#include <memory>
#include <vector>

#include "base/lanes.h"
#include "linear/sparse_cholesky.h"

namespace whittle {

/// Minimises ½ tr(Xᵀ A X) − tr(Bᵀ X) over X (#n×3) with some rows of X held where they are: the held rows are
/// eliminated and the free block is factored once. Works on corrections, so the single precision of the factor costs
/// nothing in the end: the error of each solve is relative to the step that it takes.
class ConstrainedQuadratic {
 public:
  ConstrainedQuadratic();
  ~ConstrainedQuadratic();
  ConstrainedQuadratic(ConstrainedQuadratic&&) noexcept;
  ConstrainedQuadratic& operator=(ConstrainedQuadratic&&) noexcept;

  /// Factors the free block of A (#n×#n, symmetric, positive definite on the free rows; only the lower triangle is
  /// read). `held` may hold an index twice. A is taken over and let go before the factorization, whose memory is the
  /// peak. Fails with `numericalFailure`.
  /// @param ordering of all rows of A, held ones too, in blocks of 1
  Status prepare(SparseMatrix A, const std::vector<Index>& held, const Ordering& ordering = {});

  /// Begins to prepare; `prepareNext` does it slice by slice (`slices.h`). Coordinates are kept by the caller until
  /// then.
  void beginPrepare(SparseMatrix A, std::vector<Index> held, const Ordering& ordering = {});
  /// Does a slice.
  /// @param share out: the share of the work that is done; 1 after a failure, too
  Status prepareNext(double& share, double work = kSliceWork);

  /// Makes of residuals B − A X at some X the corrections ΔX that lead from there to the minimum, of held rows zero.
  /// Allocates nothing.
  /// @param residual rows of X filled up to whole batches, and one more that nobody reads (`paddedRows`)
  void correct(LaneRows& residual);
  static std::size_t paddedRows(Index n) { return 4 * batchCount(n) + 1; }

 private:
  struct Preparation;

  std::vector<Index> held_;
  bool allHeld_ = false;
  SparseCholesky cholesky_;
  std::unique_ptr<Preparation> preparation_;  // while it goes on
};

}  // namespace whittle
