#pragma once

#include <array>
#include <vector>

#include "base/sparse_matrix.h"

namespace whittle {

/// A symmetric matrix of 3×3 blocks, one for each node and each coupled pair of nodes, whose values change and whose
/// pattern does not: blocks are added straight into the values of a sparse matrix.
class SymmetricBlocks {
 public:
  SymmetricBlocks() = default;
  /// @param pairs coupled nodes, in any order, however often each
  SymmetricBlocks(Index nodes, std::vector<std::array<Index, 2>> pairs);

  Index nodes() const { return static_cast<Index>(start_.size()) - 1; }
  /// The place of the block of a pair, or of a node (twice the same).
  Index place(Index node, Index other) const;

  void setZero() { std::fill(matrix_.valuePtr(), matrix_.valuePtr() + matrix_.nonZeros(), 0.0); }
  /// Adds to the block at a place, its rows those of the larger node and its columns those of the smaller one.
  void add(Index place, const Mat3& block) {
    const Place& at = places_[place];
    double* const values = matrix_.valuePtr() + at.first;
    for (int column = 0; column < 3; ++column) {
      for (int row = 0; row < 3; ++row) values[column * at.stride + row] += block(row, column);
    }
  }

  /// #3 nodes×#3 nodes, the lower triangle and whole blocks on the diagonal.
  const SparseMatrix& matrix() const { return matrix_; }

 private:
  struct Place {
    Index first;   // of the values
    Index stride;  // to the next column
  };

  std::vector<Index> start_;  // #nodes + 1, into `rows_`
  std::vector<Index> rows_;   // of each node itself and its larger neighbours, rising
  std::vector<Place> places_;
  SparseMatrix matrix_;
};

}  // namespace whittle
