#include "linear/entry_places.h"

#include <algorithm>
#include <numeric>

#include "base/tiering.h"

namespace whittle {

namespace {

/// Counts, by columns of L, the entries of a column of A's lower triangle.
WHITTLE_OWN_FUNCTION void countEntries(const SparseMatrix& A, Index column, const Index* newOf, Index* counts) {
  for (Index p = A.outerIndexPtr()[column]; p < A.outerIndexPtr()[column + 1]; ++p) {
    const Index row = A.innerIndexPtr()[p];
    if (row >= column) ++counts[std::min(newOf[row], newOf[column])];
  }
}

}  // namespace

EntryPlaces::EntryPlaces(const SparseMatrix& A, const Supernodes& supernodes) {
  const Index n = static_cast<Index>(A.cols());
  // By columns of L first. Two ahead, so that filling them in leaves where each begins.
  std::vector<Index> start(n + 2, 0);
  for (Index column = 0; column < n; ++column) countEntries(A, column, supernodes.newOf.data(), start.data() + 2);
  std::partial_sum(start.begin(), start.end(), start.begin());
  entries_.resize(start.back());
  for (Index column = 0; column < n; ++column) sortEntries(A, column, supernodes, start.data() + 1);

  std::vector<Index> placeOf(n);
  start_.assign(1, 0);
  for (Index s = 0; s < supernodes.count(); ++s) {
    placeInPanel(supernodes, s, start.data(), placeOf.data());
    start_.push_back(start[supernodes.columnStart[s + 1]]);
  }
}

/// Puts the entries of a column of A's lower triangle behind those that the columns of L have already, with their rows
/// for places.
WHITTLE_OWN_FUNCTION void EntryPlaces::sortEntries(const SparseMatrix& A, Index column, const Supernodes& supernodes,
                                                   Index* ends) {
  const Index* const newOf = supernodes.newOf.data();
  for (Index p = A.outerIndexPtr()[column]; p < A.outerIndexPtr()[column + 1]; ++p) {
    if (A.innerIndexPtr()[p] < column) continue;
    const auto [target, row] = std::minmax(newOf[column], newOf[A.innerIndexPtr()[p]]);
    entries_[ends[target]++] = {p, row};
  }
}

/// Makes places in a panel of rows.
/// @param start first entry of each column of L, and their end
WHITTLE_OWN_FUNCTION void EntryPlaces::placeInPanel(const Supernodes& supernodes, Index s, const Index* start,
                                                    Index* placeOf) {
  const Index* const rows = supernodes.rowsOf(s);
  const Index height = supernodes.height(s), first = supernodes.columnStart[s];
  for (Index r = 0; r < height; ++r) placeOf[rows[r]] = r;
  for (Index j = 0; j < supernodes.columns(s); ++j) {
    for (Index e = start[first + j]; e < start[first + j + 1]; ++e) {
      entries_[e].place = placeOf[entries_[e].place] + j * height;
    }
  }
}

}  // namespace whittle
