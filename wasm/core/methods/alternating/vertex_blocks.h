#pragma once

#include <vector>

#include "base/sparse_matrix.h"
#include "methods/alternating/point_rows.h"
#include "methods/alternating/rest_surface.h"

namespace whittle {

/// The pattern of the vertex solve's matrix: unknowns 3v + axis, symmetric, of which the lower triangle is kept, in 3×3
/// blocks for vertices that a face, or a row of constants, has together.
class VertexBlocks {
 public:
  VertexBlocks() = default;
  VertexBlocks(const RestSurface& surface, const std::vector<PointRow>& rows);

  /// A matrix of zeros with this pattern.
  const SparseMatrix& zero() const { return zero_; }

  /// Adds B to the block of rows of vertex v and columns of w, and its transpose to that of w and v.
  void add(Index v, Index w, const Mat3& B, double* values) const {
    v >= w ? addBelow(v, w, findBlock(v, w), B, values) : addBelow(w, v, findBlock(w, v), B.transpose(), values);
  }
  /// Adds a symmetric B to the diagonal block of a vertex.
  void addDiagonal(Index v, const Mat3& B, double* values) const;
  /// Adds K (e·e) of an edge between its two vertices: K on both diagonal blocks, −K between them.
  void addEdge(Index edge, const Mat3& K, double* values) const;

 private:
  Index findBlock(Index low, Index column) const;
  void addBelow(Index row, Index column, Index block, const Mat3& B, double* values) const;
  double* columnOf(Index vertex, int axis, double* values) const {
    return values + zero_.outerIndexPtr()[3 * vertex + axis];
  }

  SparseMatrix zero_;
  std::vector<Index> start_;  // #V + 1: the vertices below v in its columns are lower_[start_[v]] …, ascending
  std::vector<Index> lower_;
  std::vector<Index> blockOf_;  // #E, place of an edge's block among those of its column
  std::vector<std::array<Index, 2>> ends_;
};

}  // namespace whittle
