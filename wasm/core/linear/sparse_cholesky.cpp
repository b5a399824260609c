#include "linear/sparse_cholesky.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "base/tiering.h"

namespace whittle {

namespace {

/// Pivots that cancellation has eaten (rounding leaves some multiples of ε) say only that the matrix is singular to working
/// precision; those out of range would overflow in single precision.
bool arePivotsSound(const double* factor, Index stride, const double* diagonal, Index columns) {
  constexpr double kNoise = 64 * std::numeric_limits<double>::epsilon();
  for (Index j = 0; j < columns; ++j) {
    const double pivot = factor[static_cast<std::ptrdiff_t>(j) * stride];  // its square root
    if (!(pivot * pivot > kNoise * diagonal[j] && pivot > 1e-30 && pivot < 1e30)) return false;
  }
  return true;
}

/// Counts, by columns of L, the entries of a column of A's lower triangle.
WHITTLE_OWN_FUNCTION void countEntries(const SparseMatrix& A, Index column, const Index* newOf, Index* counts) {
  for (Index p = A.outerIndexPtr()[column]; p < A.outerIndexPtr()[column + 1]; ++p) {
    const Index row = A.innerIndexPtr()[p];
    if (row >= column) ++counts[std::min(newOf[row], newOf[column])];
  }
}

}  // namespace

void SparseCholesky::analyze(const SparseMatrix& A, const Ordering& ordering) {
  const Index unknowns = static_cast<Index>(A.cols());
  std::vector<Index> rowOf(unknowns);
  std::iota(rowOf.begin(), rowOf.end(), 0);
  analyze(A, ordering, rowOf, unknowns);
  rhs_.assign(unknowns + 1, {});
}

void SparseCholesky::analyze(const SparseMatrix& A, const Ordering& ordering, const std::vector<Index>& rowOf, Index spare) {
  supernodes_ = analyzeSupernodes(A, ordering);
  placeRows(rowOf, spare);
  placeEntries(A);
  measureStack();
}

void SparseCholesky::placeRows(const std::vector<Index>& rowOf, Index spare) {
  std::vector<Index> rowAt(rowOf.size());
  for (std::size_t unknown = 0; unknown < rowOf.size(); ++unknown) rowAt[supernodes_.newOf[unknown]] = rowOf[unknown];
  Index mostTiles = 0, mostColumns = 0;
  paddedRows_.clear();
  paddedStart_.assign(1, 0);
  tileStart_.assign(1, 0);
  for (Index s = 0; s < supernodes_.count(); ++s) {
    const Index* rows = supernodes_.rowsOf(s);
    const Index tiles = (supernodes_.height(s) + 3) / 4;
    for (Index i = 0; i < supernodes_.height(s); ++i) paddedRows_.push_back(rowAt[rows[i]]);
    paddedStart_.push_back(paddedStart_.back() + 4 * tiles);
    paddedRows_.resize(paddedStart_.back(), spare);
    tileStart_.push_back(tileStart_.back() + static_cast<std::size_t>(tiles) * supernodes_.columns(s));
    mostTiles = std::max(mostTiles, tiles);
    mostColumns = std::max(mostColumns, supernodes_.columns(s));
  }
  tiles_.resize(tileStart_.back());
  diagonal_.resize(mostColumns);
  scratch_.assign(std::max(3 * mostTiles, mostColumns), {});
}

void SparseCholesky::placeEntries(const SparseMatrix& A) {
  const Index n = static_cast<Index>(A.cols());
  // By columns of L first. Two ahead, so that filling them in leaves where each begins.
  std::vector<Index> start(n + 2, 0);
  for (Index column = 0; column < n; ++column) countEntries(A, column, supernodes_.newOf.data(), start.data() + 2);
  std::partial_sum(start.begin(), start.end(), start.begin());
  entries_.resize(start.back());
  for (Index column = 0; column < n; ++column) sortEntries(A, column, start.data() + 1);

  std::vector<Index> placeOf(n);
  entryStart_.assign(1, 0);
  for (Index s = 0; s < supernodes_.count(); ++s) {
    placeInPanel(s, start.data(), placeOf.data());
    entryStart_.push_back(start[supernodes_.columnStart[s + 1]]);
  }
}

/// Puts the entries of a column of A's lower triangle behind those that the columns of L have already, with their rows for places.
WHITTLE_OWN_FUNCTION void SparseCholesky::sortEntries(const SparseMatrix& A, Index column, Index* ends) {
  const Index* const newOf = supernodes_.newOf.data();
  for (Index p = A.outerIndexPtr()[column]; p < A.outerIndexPtr()[column + 1]; ++p) {
    if (A.innerIndexPtr()[p] < column) continue;
    const auto [target, row] = std::minmax(newOf[column], newOf[A.innerIndexPtr()[p]]);
    entries_[ends[target]++] = {p, row};
  }
}

/// From rows to places in a panel.
/// @param start first entry of each column of L, and their end
WHITTLE_OWN_FUNCTION void SparseCholesky::placeInPanel(Index s, const Index* start, Index* placeOf) {
  const Index* const rows = supernodes_.rowsOf(s);
  const Index height = supernodes_.height(s), first = supernodes_.columnStart[s];
  for (Index r = 0; r < height; ++r) placeOf[rows[r]] = r;
  for (Index j = 0; j < supernodes_.columns(s); ++j) {
    for (Index e = start[first + j]; e < start[first + j + 1]; ++e) entries_[e].place = placeOf[entries_[e].place] + j * height;
  }
}

void SparseCholesky::measureStack() {
  peakUpdates_ = 0;
  std::size_t stack = 0;
  std::vector<std::size_t> ofChildren(supernodes_.count(), 0);
  for (Index s = 0; s < supernodes_.count(); ++s) {
    const std::size_t update = static_cast<std::size_t>(updateSize(s)) * updateSize(s);
    peakUpdates_ = std::max(peakUpdates_, stack + update);
    stack += update - ofChildren[s];
    if (supernodes_.parent[s] >= 0) ofChildren[supernodes_.parent[s]] += update;
  }
}

Status SparseCholesky::factorize(const SparseMatrix& A, bool keepWorkspace) {
  work_.begin(supernodes_, peakUpdates_);
  const bool definite = eliminate(A);
  if (!keepWorkspace) work_ = {};
  if (definite) return {};
  return Status::failure(Code::numericalFailure,
                         "the linear system is not positive definite; the mesh may hold faces too thin to compute with");
}

bool SparseCholesky::eliminate(const SparseMatrix& A) {
  for (Index s = 0; s < supernodes_.count(); ++s) {
    double* front = work_.open(s);
    for (Index e = entryStart_[s]; e < entryStart_[s + 1]; ++e) front[entries_[e].place] += A.valuePtr()[entries_[e].value];
    const Index columns = supernodes_.columns(s), stride = supernodes_.height(s) + 1;
    for (Index j = 0; j < columns; ++j) diagonal_[j] = front[static_cast<std::ptrdiff_t>(j) * stride];
    if (!work_.eliminate(s) || !arePivotsSound(front, stride, diagonal_.data(), columns)) return false;
    packTiles(work_.inverted(s), supernodes_.height(s), columns, tiles_.data() + tileStart_[s]);
  }
  return true;
}

SolvePanel SparseCholesky::solvePanel(Index s) const {
  return {tiles_.data() + tileStart_[s], paddedRows_.data() + paddedStart_[s], supernodes_.columns(s), supernodes_.height(s)};
}

void SparseCholesky::solve(Points& rhs) {
  for (Index i = 0; i < rhs.rows(); ++i) {
    rhs_[i] = {static_cast<float>(rhs(i, 0)), static_cast<float>(rhs(i, 1)), static_cast<float>(rhs(i, 2)), 0};
  }
  solve(rhs_.data());
  for (Index i = 0; i < rhs.rows(); ++i) rhs.row(i) << rhs_[i].x, rhs_[i].y, rhs_[i].z;
}

void SparseCholesky::solve(LaneRow* rows) {
  for (Index s = 0; s < supernodes_.count(); ++s) panelForward(solvePanel(s), rows, scratch_.data());
  for (Index s = supernodes_.count() - 1; s >= 0; --s) panelBackward(solvePanel(s), rows, scratch_.data());
}

}  // namespace whittle
