#include "linear/sparse_cholesky.h"

#include <algorithm>
#include <limits>
#include <numeric>

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

}  // namespace

void SparseCholesky::analyze(const SparseMatrix& A, const Ordering& ordering) {
  supernodes_ = analyzeSupernodes(A, ordering);
  placeRows();
  placeEntries(A);
  measureStack();
}

void SparseCholesky::placeRows() {
  const Index unknowns = static_cast<Index>(supernodes_.newOf.size());
  Index mostTiles = 0, mostColumns = 0;
  paddedRows_.clear();
  paddedStart_.assign(1, 0);
  tileStart_.assign(1, 0);
  for (Index s = 0; s < supernodes_.count(); ++s) {
    const Index* rows = supernodes_.rowsOf(s);
    const Index tiles = (supernodes_.height(s) + 3) / 4;
    paddedRows_.insert(paddedRows_.end(), rows, rows + supernodes_.height(s));
    paddedStart_.push_back(paddedStart_.back() + 4 * tiles);
    paddedRows_.resize(paddedStart_.back(), unknowns);
    tileStart_.push_back(tileStart_.back() + static_cast<std::size_t>(tiles) * supernodes_.columns(s));
    mostTiles = std::max(mostTiles, tiles);
    mostColumns = std::max(mostColumns, supernodes_.columns(s));
  }
  tiles_.resize(tileStart_.back());
  diagonal_.resize(mostColumns);
  rhs_.assign(unknowns + 1, {});
  scratch_.assign(std::max(3 * mostTiles, mostColumns), {});
}

void SparseCholesky::placeEntries(const SparseMatrix& A) {
  std::vector<Index> supernodeOf(A.cols());
  for (Index s = 0; s < supernodes_.count(); ++s) {
    std::fill_n(supernodeOf.begin() + supernodes_.columnStart[s], supernodes_.columns(s), s);
  }
  const auto forEachEntry = [&](auto&& visit) {
    for (Index old = 0; old < A.cols(); ++old) {
      for (Index p = A.outerIndexPtr()[old]; p < A.outerIndexPtr()[old + 1]; ++p) {
        const Index oldRow = A.innerIndexPtr()[p];
        if (oldRow < old) continue;
        const auto [column, row] = std::minmax(supernodes_.newOf[old], supernodes_.newOf[oldRow]);
        visit(p, supernodeOf[column], row, column);
      }
    }
  };
  entryStart_.assign(supernodes_.count() + 1, 0);
  forEachEntry([&](Index, Index s, Index, Index) { ++entryStart_[s + 1]; });
  std::partial_sum(entryStart_.begin(), entryStart_.end(), entryStart_.begin());
  entries_.resize(entryStart_.back());
  std::vector<Index> next(entryStart_.begin(), entryStart_.end() - 1);
  forEachEntry([&](Index value, Index s, Index row, Index column) {
    const Index* rows = supernodes_.rowsOf(s);
    const Index height = supernodes_.height(s);
    const Index place = static_cast<Index>(std::lower_bound(rows, rows + height, row) - rows);
    entries_[next[s]++] = {value, place + (column - supernodes_.columnStart[s]) * height};
  });
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
    row(i) = {static_cast<float>(rhs(i, 0)), static_cast<float>(rhs(i, 1)), static_cast<float>(rhs(i, 2)), 0};
  }
  solve();
  for (Index i = 0; i < rhs.rows(); ++i) rhs.row(i) << row(i).x, row(i).y, row(i).z;
}

void SparseCholesky::solve() {
  for (Index s = 0; s < supernodes_.count(); ++s) panelForward(solvePanel(s), rhs_.data(), scratch_.data());
  for (Index s = supernodes_.count() - 1; s >= 0; --s) panelBackward(solvePanel(s), rhs_.data(), scratch_.data());
}

}  // namespace whittle
