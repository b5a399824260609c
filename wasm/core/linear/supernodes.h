#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "linear/elimination_tree.h"
#include "linear/ordering.h"

namespace whittle {

/// The pattern of L as dense panels: runs of columns that share their rows. A panel of k columns and m rows holds m×k
/// entries; its first k rows are its own columns. Unknowns that are kept have no column, only rows.
struct Supernodes {
  std::vector<Index> newOf;           // #unknowns: position of each unknown in the factor's order
  std::vector<Index> columnStart;     // #supernodes + 1: first column of each
  std::vector<std::size_t> rowStart;  // #supernodes + 1: into `rows`
  std::vector<Index> rows;            // ascending within each supernode
  std::vector<Index> parent;          // supernode that takes the update, −1 for roots; children come before parents

  Index count() const { return static_cast<Index>(columnStart.size()) - 1; }
  Index columns(Index s) const { return columnStart[s + 1] - columnStart[s]; }
  Index height(Index s) const { return static_cast<Index>(rowStart[s + 1] - rowStart[s]); }
  const Index* rowsOf(Index s) const { return rows.data() + rowStart[s]; }
};

/// Orders the unknowns of A for a sparse factor and finds its supernodes, in slices. Columns with nearly equal patterns
/// are taken together: a few stored zeros cost less than many small panels. Where unknowns come in blocks, the graph of
/// their nodes is what is ordered and analyzed, so the columns of a supernode come in whole blocks.
class SupernodeAnalysis {
 public:
  /// @param A to be kept by the caller until the analysis is done, like the coordinates
  SupernodeAnalysis(const SparseMatrix& A, const Ordering& ordering) : A_(A), settings_(ordering) {}

  /// Does a slice; returns the share that is done.
  double next(double work = kSliceWork);
  Supernodes take() { return std::move(result_); }

 private:
  std::vector<Index> order();
  void findSupernodes();

  const SparseMatrix& A_;
  Ordering settings_;
  int stage_ = 0;
  Graph graph_;
  std::optional<EliminationOrdering> ordering_;
  EliminationTree tree_;
  Supernodes result_;
};

}  // namespace whittle
