#pragma once

#include <memory>
#include <vector>

#include "base/sparse_matrix.h"
#include "base/status.h"
#include "linear/columns.h"
#include "linear/conjugate_gradients.h"
#include "linear/ordering.h"
#include "linear/slices.h"
#include "simd/lanes.h"

namespace whittle {

/// Cholesky factorization P A Pᵀ = L Lᵀ of a sparse symmetric positive definite matrix, in three stages so that a
/// caller repeats only what changed: `analyze` for a new pattern, `factorize` for new values, `solve` for a new
/// right-hand side. The first two can be done in slices (`slices.h`).
///
/// The factorization is in double precision; what is kept of it for the solves is rounded once to single precision. So
/// a solution by `solve` is good to about 1e-6 of its size, which is enough for callers that solve for a correction of
/// what they have, as iterations do; `solveRefined` gives double precision. Of A only the lower triangle is read.
class SparseCholesky {
 public:
  SparseCholesky();
  ~SparseCholesky();
  SparseCholesky(SparseCholesky&&) noexcept;
  SparseCholesky& operator=(SparseCholesky&&) noexcept;

  /// Orders the unknowns and finds the pattern of L. Reads only the pattern of A, and coordinates if they are given.
  /// Where unknowns come in blocks, their number must be a multiple of the block size; entries may be missing inside
  /// blocks.
  void analyze(const SparseMatrix& A, const Ordering& ordering = {});

  /// Begins to analyze; `analyzeNext` does it slice by slice. A and the coordinates are kept by the caller until then.
  void beginAnalyze(const SparseMatrix& A, const Ordering& ordering = {});
  /// Begins to analyze for a caller whose right-hand sides stand in rows of their own, where `solve(LaneRow*)` then
  /// solves them.
  /// @param rowOf the row of each unknown
  /// @param spare a row that nobody reads
  void beginAnalyze(const SparseMatrix& A, const Ordering& ordering, std::vector<Index> rowOf, Index spare);
  /// Does a slice; returns the share that is done.
  double analyzeNext(double work = kSliceWork);

  /// Computes L for a matrix of the analyzed pattern. Fails with `numericalFailure` if A is not positive definite
  /// or singular to working precision.
  /// @param keepWorkspace keep the working memory for the next factorization, which then allocates nothing; for callers
  ///   that factorize often. Without it that memory is free as soon as L is there.
  Status factorize(const SparseMatrix& A, bool keepWorkspace = false);

  /// Begins to factorize; `factorizeNext` does it slice by slice. A is kept by the caller until then; the factor that
  /// was there is lost.
  void beginFactorize(const SparseMatrix& A, bool keepWorkspace = false);
  /// Does a slice.
  /// @param share out: the share of the work that is done; 1 after a failure, too
  Status factorizeNext(double& share, double work = kSliceWork);

  /// With `Ordering::kept`, the factorization leaves a system S in the kept unknowns, S = A_kk − A_ke A_ee⁻¹ A_ek
  /// (lower triangle, numbered from 0), for the caller to solve in a way of its own, and A X = B is solved by three
  /// calls: `forward` makes of the rows of kept unknowns the right-hand sides of S; the caller puts the solutions in
  /// their place; `backward` finds the rest. `solve` and `solveRefined` are for systems that are eliminated whole.
  SparseMatrix takeSchurComplement();
  void forward(LaneRow* rows);
  void backward(LaneRow* rows);

  /// Overwrites right-hand sides (#unknowns×k, any k, rows or columns contiguous or not) with the solutions. Up to 24
  /// columns share a pass over L, which costs hardly more than its arithmetic: for many right-hand sides give them at
  /// once. Allocates only if k is greater than ever before, beyond 3.
  void solve(Columns X);

  /// Solves for three right-hand sides in single precision, in place and in one pass over L. Allocates nothing.
  /// @param rows where `analyze` was told that they are; else #unknowns + 1, of which the last is spare
  void solve(LaneRow* rows);

  /// Solves A X = B to double accuracy, by conjugate gradients with the factor for preconditioner. By default each
  /// column is solved to ‖b − A x‖ ≤ 1e-12 ‖b‖, or as near as rounding lets it be; the report says whether that was
  /// reached. A may be
  /// - the factored matrix: what separates the two is single precision, and two or three iterations do; or
  /// - a later one on the same pattern: a system that changed little takes a few iterations instead of a factorization
  ///   (with weights between half and twice the old ones, about 12 for a residual of 1e-6).
  ///
  /// Allocates only if k is not that of the call before.
  /// @param B #unknowns×k, any k; not the memory of X
  /// @param X #unknowns×k, in: where to start, zero if nothing is known; out: the solution
  /// @returns `numericalFailure` if A turns out to be indefinite or numbers are not finite; X is then where that was
  ///   noticed
  Status solveRefined(const SparseMatrix& A, ConstColumns B, Columns X, const ConjugateGradients::Limits& limits = {},
                      ConjugateGradients::Report* report = nullptr);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace whittle
