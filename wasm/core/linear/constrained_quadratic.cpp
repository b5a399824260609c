#include "linear/constrained_quadratic.h"

#include <utility>

namespace whittle {

namespace {

constexpr Index kHeld = -1;

/// Shares of the work: what is done after the analysis, by whether the order is known.
constexpr double kAnalyzed = 0.4, kAnalyzedInOrder = 0.15;

}  // namespace

/// What is needed until the system is factored.
struct ConstrainedQuadratic::Preparation {
  SparseMatrix A;  // until its free block is taken
  Ordering ordering;
  std::vector<Index> freeRows;
  SparseMatrix freeBlock;  // lower triangle
  Points coordinates;      // of the free rows, where they are known
  enum class Stage { block, analysis, factorization } stage = Stage::block;

  Preparation(SparseMatrix matrix, const Ordering& given) : A(std::move(matrix)), ordering(given) {}
  void takeFreeBlock(const std::vector<Index>& held);
  Ordering orderingOfFree();
};

ConstrainedQuadratic::ConstrainedQuadratic() = default;
ConstrainedQuadratic::~ConstrainedQuadratic() = default;
ConstrainedQuadratic::ConstrainedQuadratic(ConstrainedQuadratic&&) noexcept = default;
ConstrainedQuadratic& ConstrainedQuadratic::operator=(ConstrainedQuadratic&&) noexcept = default;

void ConstrainedQuadratic::Preparation::takeFreeBlock(const std::vector<Index>& held) {
  std::vector<Index> freeIndex(A.rows(), 0);
  for (const Index row : held) freeIndex[row] = kHeld;
  for (Index row = 0; row < A.rows(); ++row) {
    if (freeIndex[row] == kHeld) continue;
    freeIndex[row] = static_cast<Index>(freeRows.size());
    freeRows.push_back(row);
  }
  const Index freeCount = static_cast<Index>(freeRows.size());
  freeBlock.resize(freeCount, freeCount);
  freeBlock.reserve(A.nonZeros());
  for (Index column = 0; column < freeCount; ++column) {
    freeBlock.startVec(column);
    for (SparseMatrix::InnerIterator entry(A, freeRows[column]); entry; ++entry) {
      // Free rows keep their order, so the block is filled front to back.
      const Index row = freeIndex[entry.row()];
      if (row >= column) freeBlock.insertBack(row, column) = entry.value();
    }
  }
  freeBlock.finalize();
  A = SparseMatrix();
}

Ordering ConstrainedQuadratic::Preparation::orderingOfFree() {
  if (!ordering.coordinates) return ordering;
  coordinates.resize(freeRows.size(), 3);
  for (std::size_t i = 0; i < freeRows.size(); ++i) coordinates.row(i) = ordering.coordinates->row(freeRows[i]);
  Ordering result = ordering;
  result.coordinates = &coordinates;
  return result;
}

void ConstrainedQuadratic::beginPrepare(SparseMatrix A, std::vector<Index> held, const Ordering& ordering) {
  held_ = std::move(held);
  preparation_ = std::make_unique<Preparation>(std::move(A), ordering);
}

Status ConstrainedQuadratic::prepareNext(double& share, double work) {
  using Stage = Preparation::Stage;
  Preparation& now = *preparation_;
  const double analyzed = now.ordering.isOrdered ? kAnalyzedInOrder : kAnalyzed;
  Status status;
  switch (now.stage) {
    case Stage::block: {
      const Index spare = static_cast<Index>(paddedRows(static_cast<Index>(now.A.rows()))) - 1;
      now.takeFreeBlock(held_);
      allHeld_ = now.freeRows.empty();
      share = allHeld_ ? 1 : 0;
      if (!allHeld_) cholesky_.beginAnalyze(now.freeBlock, now.orderingOfFree(), now.freeRows, spare);
      now.stage = Stage::analysis;
      break;
    }
    case Stage::analysis: {
      const double done = cholesky_.analyzeNext(work);
      share = analyzed * done;
      if (done < 1) break;
      now.coordinates.resize(0, 3);
      cholesky_.beginFactorize(now.freeBlock);
      now.stage = Stage::factorization;
      break;
    }
    case Stage::factorization: {
      double done;
      status = cholesky_.factorizeNext(done, work);
      share = done == 1 ? 1 : analyzed + (1 - analyzed) * done;
      break;
    }
  }
  if (share == 1) preparation_.reset();
  return status;
}

Status ConstrainedQuadratic::prepare(SparseMatrix A, const std::vector<Index>& held, const Ordering& ordering) {
  beginPrepare(std::move(A), held, ordering);
  Status status;
  for (double share = 0; share < 1;) status = prepareNext(share);
  return status;
}

void ConstrainedQuadratic::correct(LaneRows& residual) {
  for (const Index row : held_) residual[row] = {};
  if (!allHeld_) cholesky_.solve(residual.data());
}

}  // namespace whittle
