#include "linear/constrained_quadratic.h"

namespace whittle {

namespace {

constexpr Index kHeld = -1;

}  // namespace

Status ConstrainedQuadratic::prepare(SparseMatrix A, const std::vector<Index>& held) {
  std::vector<Index> freeIndex(A.rows(), 0);
  for (const Index row : held) freeIndex[row] = kHeld;
  free_.clear();
  for (Index row = 0; row < A.rows(); ++row) {
    if (freeIndex[row] == kHeld) continue;
    freeIndex[row] = static_cast<Index>(free_.size());
    free_.push_back(row);
  }

  const Index freeCount = static_cast<Index>(free_.size());
  SparseMatrix freeBlock(freeCount, freeCount);
  coupling_.resize(freeCount, A.cols());
  freeBlock.reserve((A.nonZeros() + A.rows()) / 2);
  for (Index column = 0; column < A.cols(); ++column) {
    // Free rows keep their order, so both matrices are filled front to back.
    const Index freeColumn = freeIndex[column];
    SparseMatrix& target = freeColumn == kHeld ? coupling_ : freeBlock;
    const Index targetColumn = freeColumn == kHeld ? column : freeColumn;
    if (freeColumn != kHeld) coupling_.startVec(column);
    target.startVec(targetColumn);
    for (SparseMatrix::InnerIterator entry(A, column); entry; ++entry) {
      const Index row = freeIndex[entry.row()];
      const bool needed = row != kHeld && (freeColumn == kHeld || row >= freeColumn);  // of the free block, the lower half
      if (needed) target.insertBack(row, targetColumn) = entry.value();
    }
  }
  freeBlock.finalize();
  coupling_.finalize();
  A = SparseMatrix();

  rhs_.resize(freeCount, 3);
  if (freeCount == 0) return {};
  cholesky_.analyze(freeBlock);
  return cholesky_.factorize(freeBlock);
}

void ConstrainedQuadratic::solve(const Points& B, Points& X) {
  if (free_.empty()) return;
  for (std::size_t i = 0; i < free_.size(); ++i) rhs_.row(i) = B.row(free_[i]);
  for (Index column = 0; column < coupling_.cols(); ++column) {
    for (SparseMatrix::InnerIterator entry(coupling_, column); entry; ++entry) {
      rhs_.row(entry.row()) -= entry.value() * X.row(column);
    }
  }
  cholesky_.solve(rhs_);
  for (std::size_t i = 0; i < free_.size(); ++i) X.row(free_[i]) = rhs_.row(i);
}

}  // namespace whittle
