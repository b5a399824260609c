#include "linear/constrained_quadratic.h"

namespace whittle {

namespace {

constexpr Index kHeld = -1;

}  // namespace

Status ConstrainedQuadratic::prepare(SparseMatrix A, const std::vector<Index>& held, const Ordering& ordering) {
  std::vector<Index> freeIndex(A.rows(), 0);
  for (const Index row : held) freeIndex[row] = kHeld;
  std::vector<Index> freeRows;
  held_ = held;
  for (Index row = 0; row < A.rows(); ++row) {
    if (freeIndex[row] == kHeld) continue;
    freeIndex[row] = static_cast<Index>(freeRows.size());
    freeRows.push_back(row);
  }
  const Index freeCount = static_cast<Index>(freeRows.size());
  allHeld_ = freeCount == 0;
  if (allHeld_) return {};
  const Index spare = static_cast<Index>(paddedRows(static_cast<Index>(A.rows()))) - 1;

  SparseMatrix freeBlock(freeCount, freeCount);  // its lower half
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

  Ordering ofFree = ordering;
  Points coordinates;
  if (ordering.coordinates) {
    coordinates.resize(freeCount, 3);
    for (Index i = 0; i < freeCount; ++i) coordinates.row(i) = ordering.coordinates->row(freeRows[i]);
    ofFree.coordinates = &coordinates;
  }
  cholesky_.analyze(freeBlock, ofFree, freeRows, spare);
  coordinates.resize(0, 3);
  return cholesky_.factorize(freeBlock);
}

void ConstrainedQuadratic::correct(LaneRows& residual) {
  for (const Index row : held_) residual[row] = {};
  if (!allHeld_) cholesky_.solve(residual.data());
}

}  // namespace whittle
