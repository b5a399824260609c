#include "linear/sparse_cholesky.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "linear/entry_places.h"
#include "linear/multifrontal.h"
#include "linear/packed_factor.h"
#include "linear/supernodes.h"

namespace whittle {

namespace {

constexpr Index kLanes = 3;  // right-hand sides in a row of lanes

/// Pivots that cancellation has eaten (rounding leaves some multiples of ε) say only that the matrix is singular to
/// working precision; those out of range would overflow in single precision.
bool arePivotsSound(const double* factor, Index stride, const double* diagonal, Index columns) {
  constexpr double kNoise = 64 * std::numeric_limits<double>::epsilon();
  for (Index j = 0; j < columns; ++j) {
    const double pivot = factor[static_cast<std::ptrdiff_t>(j) * stride];  // its square root
    if (!(pivot * pivot > kNoise * diagonal[j] && pivot > 1e-30 && pivot < 1e30)) return false;
  }
  return true;
}

}  // namespace

/// Supernodal and multifrontal: all arithmetic is on dense panels.
struct SparseCholesky::Parts {
  Supernodes supernodes;
  EntryPlaces entries;
  PackedFactor factor;
  std::size_t peakUpdates = 0;   // largest stack of update matrices, in numbers
  std::vector<double> diagonal;  // of A, for the supernode that is being factored
  Multifrontal work;

  std::vector<Index> rowOf;  // row of lanes of each unknown
  Index rowCount = 0;        // the spare one included
  LaneRows lanes;            // groups of `rowCount` rows, each of three right-hand sides
  ConjugateGradients gradients;

  void measureStack();
  bool eliminate(const SparseMatrix& A);
  void solveTogether(Columns X);
};

SparseCholesky::SparseCholesky() : parts_(std::make_unique<Parts>()) {}
SparseCholesky::~SparseCholesky() = default;
SparseCholesky::SparseCholesky(SparseCholesky&&) noexcept = default;
SparseCholesky& SparseCholesky::operator=(SparseCholesky&&) noexcept = default;

void SparseCholesky::analyze(const SparseMatrix& A, const Ordering& ordering) {
  const Index unknowns = static_cast<Index>(A.cols());
  std::vector<Index> rowOf(unknowns);
  std::iota(rowOf.begin(), rowOf.end(), 0);
  analyze(A, ordering, rowOf, unknowns);
  parts_->lanes.assign(unknowns + 1, {});
}

void SparseCholesky::analyze(const SparseMatrix& A, const Ordering& ordering, const std::vector<Index>& rowOf,
                             Index spare) {
  parts_->rowOf = rowOf;
  parts_->rowCount = 1 + std::max(spare, rowOf.empty() ? 0 : *std::max_element(rowOf.begin(), rowOf.end()));
  parts_->supernodes = analyzeSupernodes(A, ordering);
  parts_->factor.shape(parts_->supernodes, rowOf, spare);
  parts_->entries = EntryPlaces(A, parts_->supernodes);
  parts_->measureStack();
}

void SparseCholesky::Parts::measureStack() {
  peakUpdates = 0;
  std::size_t stack = 0;
  std::vector<std::size_t> ofChildren(supernodes.count(), 0);
  Index mostColumns = 0;
  for (Index s = 0; s < supernodes.count(); ++s) {
    const std::size_t size = supernodes.height(s) - supernodes.columns(s), update = size * size;
    peakUpdates = std::max(peakUpdates, stack + update);
    stack += update - ofChildren[s];
    if (supernodes.parent[s] >= 0) ofChildren[supernodes.parent[s]] += update;
    mostColumns = std::max(mostColumns, supernodes.columns(s));
  }
  diagonal.resize(mostColumns);
}

Status SparseCholesky::factorize(const SparseMatrix& A, bool keepWorkspace) {
  parts_->work.begin(parts_->supernodes, parts_->peakUpdates);
  const bool definite = parts_->eliminate(A);
  if (!keepWorkspace) parts_->work = {};
  if (definite) return {};
  return Status::failure(Code::numericalFailure,
                         "the linear system is not positive definite; the mesh may hold faces too thin to compute with");
}

bool SparseCholesky::Parts::eliminate(const SparseMatrix& A) {
  for (Index s = 0; s < supernodes.count(); ++s) {
    double* front = work.open(s);
    entries.add(A.valuePtr(), s, front);
    const Index columns = supernodes.columns(s), stride = supernodes.height(s) + 1;
    for (Index j = 0; j < columns; ++j) diagonal[j] = front[static_cast<std::ptrdiff_t>(j) * stride];
    if (!work.eliminate(s) || !arePivotsSound(front, stride, diagonal.data(), columns)) return false;
    factor.pack(s, work.inverted(s));
  }
  return true;
}

void SparseCholesky::solve(LaneRow* rows) { parts_->factor.solve(rows); }

void SparseCholesky::solve(Columns X) {
  for (Index first = 0; first < X.count(); first += ConjugateGradients::kBatch) {
    parts_->solveTogether(X.part(first, std::min(ConjugateGradients::kBatch, X.count() - first)));
  }
}

void SparseCholesky::Parts::solveTogether(Columns X) {
  const Index groups = (X.count() + kLanes - 1) / kLanes;
  const std::size_t needed = static_cast<std::size_t>(groups) * rowCount;
  if (lanes.size() < needed) lanes.resize(needed);
  const auto rowsOf = [&](Index group) { return lanes.data() + static_cast<std::ptrdiff_t>(group) * rowCount; };
  const auto at = [&](Index i, Index c) { return c < X.count() ? static_cast<float>(X(i, c)) : 0.0f; };
  for (Index g = 0; g < groups; ++g) {
    const Index c = kLanes * g;
    for (Index i = 0; i < X.rows(); ++i) rowsOf(g)[rowOf[i]] = {at(i, c), at(i, c + 1), at(i, c + 2), 0};
  }
  factor.solve(lanes.data(), groups, rowCount);
  for (Index g = 0; g < groups; ++g) {
    for (Index i = 0; i < X.rows(); ++i) {
      const LaneRow& row = rowsOf(g)[rowOf[i]];
      const float numbers[kLanes] = {row.x, row.y, row.z};
      for (Index c = kLanes * g; c < std::min(kLanes * (g + 1), X.count()); ++c) X(i, c) = numbers[c - kLanes * g];
    }
  }
}

Status SparseCholesky::solveRefined(const SparseMatrix& A, ConstColumns B, Columns X,
                                    const ConjugateGradients::Limits& limits, ConjugateGradients::Report* report) {
  ConjugateGradients::Report unread;
  return parts_->gradients.solve(A, [this](Columns R) { solve(R); }, B, X, limits, report ? *report : unread);
}

}  // namespace whittle
