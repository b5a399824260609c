#include "linear/sparse_cholesky.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "linear/numeric_factorization.h"

namespace whittle {

namespace {

constexpr Index kLanes = 3;  // right-hand sides in a row of lanes

/// @param columns at most three; those that are missing are zero
void toLanes(Columns columns, const std::vector<Index>& rowOf, LaneRow* rows) {
  const Index count = columns.count();
  const auto number = [&](Index i, Index c) { return c < count ? static_cast<float>(columns(i, c)) : 0.0f; };
  for (Index i = 0; i < columns.rows(); ++i) rows[rowOf[i]] = {number(i, 0), number(i, 1), number(i, 2), 0};
}

void fromLanes(const LaneRow* rows, const std::vector<Index>& rowOf, Columns columns) {
  const Index count = columns.count();
  for (Index i = 0; i < columns.rows(); ++i) {
    const LaneRow& row = rows[rowOf[i]];
    columns(i, 0) = row.x;
    if (count > 1) columns(i, 1) = row.y;
    if (count > 2) columns(i, 2) = row.z;
  }
}

}  // namespace

/// Supernodal and multifrontal: all arithmetic is on dense panels.
struct SparseCholesky::Parts {
  Supernodes supernodes;
  EntryPlaces entries;
  PackedFactor factor;
  NumericFactorization numeric{supernodes, entries, factor};

  // While an analysis goes on
  enum class Stage { supernodes, factor, entries, done } stage = Stage::done;
  const SparseMatrix* pattern = nullptr;
  std::optional<SupernodeAnalysis> symbolic;

  std::vector<Index> rowOf;  // row of lanes of each unknown
  Index spare = 0;
  Index rowCount = 0;  // the spare one included
  LaneRows lanes;      // groups of `rowCount` rows, each of three right-hand sides
  ConjugateGradients gradients;

  void solveTogether(Columns X);
};

SparseCholesky::SparseCholesky() : parts_(std::make_unique<Parts>()) {}
SparseCholesky::~SparseCholesky() = default;
SparseCholesky::SparseCholesky(SparseCholesky&&) noexcept = default;
SparseCholesky& SparseCholesky::operator=(SparseCholesky&&) noexcept = default;

void SparseCholesky::beginAnalyze(const SparseMatrix& A, const Ordering& ordering) {
  const Index unknowns = static_cast<Index>(A.cols());
  std::vector<Index> rowOf(unknowns);
  std::iota(rowOf.begin(), rowOf.end(), 0);
  beginAnalyze(A, ordering, std::move(rowOf), unknowns);
  parts_->lanes.assign(unknowns + 1, {});
}

void SparseCholesky::beginAnalyze(const SparseMatrix& A, const Ordering& ordering, std::vector<Index> rowOf,
                                  Index spare) {
  parts_->rowCount = 1 + std::max(spare, rowOf.empty() ? 0 : *std::max_element(rowOf.begin(), rowOf.end()));
  parts_->rowOf = std::move(rowOf);
  parts_->spare = spare;
  parts_->pattern = &A;
  parts_->symbolic.emplace(A, ordering);
  parts_->stage = Parts::Stage::supernodes;
}

double SparseCholesky::analyzeNext(double work) {
  using Stage = Parts::Stage;
  constexpr double kSupernodes = 0.7, kFactor = 0.85;  // shares that are done after these
  Parts& parts = *parts_;
  switch (parts.stage) {
    case Stage::supernodes: {
      const double share = parts.symbolic->next(work);
      if (share < 1) return share * kSupernodes;
      parts.supernodes = parts.symbolic->take();
      parts.symbolic.reset();
      parts.stage = Stage::factor;
      return kSupernodes;
    }
    case Stage::factor:
      parts.factor.shape(parts.supernodes, parts.rowOf, parts.spare);
      parts.stage = Stage::entries;
      return kFactor;
    case Stage::entries:
      parts.entries = EntryPlaces(*parts.pattern, parts.supernodes);
      parts.numeric.measure();
      parts.stage = Stage::done;
      break;
    case Stage::done: break;
  }
  return 1;
}

void SparseCholesky::analyze(const SparseMatrix& A, const Ordering& ordering) {
  beginAnalyze(A, ordering);
  while (analyzeNext() < 1) {
  }
}

void SparseCholesky::beginFactorize(const SparseMatrix& A, bool keepWorkspace) {
  parts_->numeric.begin(A, keepWorkspace);
}

Status SparseCholesky::factorizeNext(double& share, double work) { return parts_->numeric.next(share, work); }

Status SparseCholesky::factorize(const SparseMatrix& A, bool keepWorkspace) {
  beginFactorize(A, keepWorkspace);
  Status status;
  for (double share = 0; share < 1;) status = factorizeNext(share);
  return status;
}

SparseMatrix SparseCholesky::takeSchurComplement() { return parts_->numeric.takeSchurComplement(); }

void SparseCholesky::forward(LaneRow* rows) { parts_->factor.forward(rows); }

void SparseCholesky::backward(LaneRow* rows) { parts_->factor.backward(rows); }

void SparseCholesky::solve(LaneRow* rows) {
  parts_->factor.forward(rows);
  parts_->factor.backward(rows);
}

void SparseCholesky::solve(Columns X) {
  for (Index first = 0; first < X.count(); first += ConjugateGradients::kBatch) {
    parts_->solveTogether(X.part(first, std::min(ConjugateGradients::kBatch, X.count() - first)));
  }
}

void SparseCholesky::Parts::solveTogether(Columns X) {
  const Index groups = (X.count() + kLanes - 1) / kLanes;
  const std::size_t needed = static_cast<std::size_t>(groups) * rowCount;
  if (lanes.size() < needed) lanes.resize(needed);
  const auto eachGroup = [&](auto&& take) {
    for (Index g = 0; g < groups; ++g) {
      const Index first = kLanes * g;
      take(X.part(first, std::min(kLanes, X.count() - first)), lanes.data() + static_cast<std::size_t>(g) * rowCount);
    }
  };
  eachGroup([&](Columns columns, LaneRow* rows) { toLanes(columns, rowOf, rows); });
  factor.forward(lanes.data(), groups, rowCount);
  factor.backward(lanes.data(), groups, rowCount);
  eachGroup([&](Columns columns, const LaneRow* rows) { fromLanes(rows, rowOf, columns); });
}

Status SparseCholesky::solveRefined(const SparseMatrix& A, ConstColumns B, Columns X,
                                    const ConjugateGradients::Limits& limits, ConjugateGradients::Report* report) {
  ConjugateGradients::Report unread;
  return parts_->gradients.solve(
      A, [this](Columns R) { solve(R); }, B, X, limits, report ? *report : unread);
}

}  // namespace whittle
