#include "linear/constrained_quadratic.h"

namespace whittle {

namespace {

constexpr Index kHeld = -1;

}  // namespace

Status ConstrainedQuadratic::prepare(SparseMatrix A, const std::vector<Index>& held, const Ordering& ordering) {
  std::vector<Index> freeIndex(A.rows(), 0);
  for (const Index row : held) freeIndex[row] = kHeld;
  free_.clear();
  held_ = held;
  for (Index row = 0; row < A.rows(); ++row) {
    if (freeIndex[row] == kHeld) continue;
    freeIndex[row] = static_cast<Index>(free_.size());
    free_.push_back(row);
  }
  const Index freeCount = static_cast<Index>(free_.size());
  if (freeCount == 0) return {};

  SparseMatrix freeBlock(freeCount, freeCount);  // its lower half
  freeBlock.reserve(A.nonZeros());
  for (Index column = 0; column < freeCount; ++column) {
    freeBlock.startVec(column);
    for (SparseMatrix::InnerIterator entry(A, free_[column]); entry; ++entry) {
      // Free rows keep their order, so the block is filled front to back.
      const Index row = freeIndex[entry.row()];
      if (row >= column) freeBlock.insertBack(row, column) = entry.value();
    }
  }
  freeBlock.finalize();
  A = SparseMatrix();

  Ordering ofFree = ordering;
  Points coordinates;
  if (ordering.coordinates) {
    coordinates.resize(freeCount, 3);
    for (Index i = 0; i < freeCount; ++i) coordinates.row(i) = ordering.coordinates->row(free_[i]);
    ofFree.coordinates = &coordinates;
  }
  cholesky_.analyze(freeBlock, ofFree);
  coordinates.resize(0, 3);
  return cholesky_.factorize(freeBlock);
}

void ConstrainedQuadratic::correct(std::vector<LaneRow>& residual) {
  for (const Index row : held_) residual[row] = {};
  if (free_.empty()) return;
  const Index freeCount = static_cast<Index>(free_.size());
  for (Index i = 0; i < freeCount; ++i) cholesky_.row(i) = residual[free_[i]];
  cholesky_.solve();
  for (Index i = 0; i < freeCount; ++i) residual[free_[i]] = cholesky_.row(i);
}

}  // namespace whittle
