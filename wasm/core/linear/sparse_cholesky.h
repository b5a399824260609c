#pragma once

#include <vector>

#include "base/sparse_matrix.h"
#include "base/status.h"
#include "linear/multifrontal.h"
#include "linear/panel_solve.h"
#include "linear/supernodes.h"

namespace whittle {

/// Cholesky factorization P A Pᵀ = L Lᵀ of a sparse symmetric positive definite matrix, in three stages so that a caller
/// repeats only what changed: `analyze` for a new pattern, `factorize` for new values, `solve` for a new right-hand side.
///
/// Supernodal and multifrontal: all arithmetic is on dense panels, in double precision. What is kept for the solves is
/// each panel as [L11⁻¹; −L21 L11⁻¹] rounded once to single precision: half the memory to stream, and products
/// instead of chains of substitutions. A solution is good to about 1e-6 of its size; callers that need more solve
/// for a correction of what they have, as iterations do anyway. Of A only the lower triangle is read.
class SparseCholesky {
 public:
  /// Orders the unknowns and finds the pattern of L. Reads only the pattern of A, and coordinates if they are given.
  /// Where unknowns come in blocks, their number must be a multiple of the block size; entries may be missing inside blocks.
  void analyze(const SparseMatrix& A, const Ordering& ordering = {});
  /// The same for callers whose right-hand sides stand in rows of their own, which `solve(LaneRow*)` then solves where they are.
  /// @param rowOf the row of each unknown
  /// @param spare a row that nobody reads
  void analyze(const SparseMatrix& A, const Ordering& ordering, const std::vector<Index>& rowOf, Index spare);

  /// Computes L for a matrix of the analyzed pattern. Fails with `numericalFailure` if A is not positive definite
  /// or singular to working precision.
  /// @param keepWorkspace keep the working memory for the next factorization, which then allocates nothing; for callers
  ///   that factorize often. Without it that memory is free as soon as L is there.
  Status factorize(const SparseMatrix& A, bool keepWorkspace = false);

  /// Overwrites three right-hand sides (#unknowns×3) with the solutions, in one pass over L. Allocates nothing.
  void solve(Points& rhs);

  /// The same in place, for callers that keep single precision.
  void solve(LaneRow* rows);

 private:
  /// Where an entry of A's value array goes: its place in the column-major panel of its supernode.
  struct Entry {
    Index value;
    Index place;
  };

  void placeRows(const std::vector<Index>& rowOf, Index spare);
  void placeEntries(const SparseMatrix& A);
  void sortEntries(const SparseMatrix& A, Index column, Index* ends);
  void placeInPanel(Index s, const Index* start, Index* placeOf);
  void measureStack();
  bool eliminate(const SparseMatrix& A);
  Index updateSize(Index s) const { return supernodes_.height(s) - supernodes_.columns(s); }
  SolvePanel solvePanel(Index s) const;

  Supernodes supernodes_;
  std::vector<Entry> entries_;            // of A's lower triangle, by supernode
  std::vector<Index> entryStart_;         // #supernodes + 1
  std::size_t peakUpdates_ = 0;           // largest stack of update matrices, in numbers
  std::vector<Index> paddedRows_;         // where the right-hand sides of each supernode stand, padded to whole tiles
  std::vector<std::size_t> paddedStart_;  // #supernodes + 1: into `paddedRows_`
  std::vector<std::size_t> tileStart_;    // #supernodes + 1: into `tiles_`
  std::vector<TileColumn> tiles_;
  std::vector<double> diagonal_;          // of A, for the supernode that is being factored
  Multifrontal work_;
  LaneRows rhs_;                           // #unknowns + 1, where callers have no rows of their own; the last takes what padding writes
  std::vector<LaneRow> scratch_;
};

}  // namespace whittle
