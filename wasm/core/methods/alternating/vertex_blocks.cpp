#include "methods/alternating/vertex_blocks.h"

#include <algorithm>

namespace whittle {

namespace {

/// The pairs of vertices that are coupled, the larger of each below the smaller: start and lists.
void collectPairs(const RestSurface& surface, const std::vector<PointRow>& rows, std::vector<Index>& start,
                  std::vector<Index>& lower) {
  std::vector<std::array<Index, 2>> pairs = surface.edges.ends;
  for (const PointRow& row : rows) {
    for (int i = 0; i < row.count; ++i) {
      for (int j = 0; j < i; ++j) {
        const auto [low, high] = std::minmax(row.vertices[i], row.vertices[j]);
        if (low != high) pairs.push_back({low, high});
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  start.assign(surface.vertexCount() + 1, 0);
  lower.reserve(pairs.size());
  for (const auto& [low, high] : pairs) {
    ++start[low + 1];
    lower.push_back(high);
  }
  for (Index v = 0; v < surface.vertexCount(); ++v) start[v + 1] += start[v];
}

/// Column 3v + axis has the diagonal block's rows from the axis down, then three rows for each vertex below.
SparseMatrix zeroMatrix(const std::vector<Index>& start, const std::vector<Index>& lower) {
  const Index vertexCount = static_cast<Index>(start.size()) - 1;
  SparseMatrix matrix(3 * vertexCount, 3 * vertexCount);
  matrix.resizeNonZeros(6 * vertexCount + 9 * static_cast<Index>(lower.size()));
  Index place = 0;
  for (Index v = 0; v < vertexCount; ++v) {
    for (Index axis = 0; axis < 3; ++axis) {
      matrix.outerIndexPtr()[3 * v + axis] = place;
      for (Index row = axis; row < 3; ++row) matrix.innerIndexPtr()[place++] = 3 * v + row;
      for (Index block = start[v]; block < start[v + 1]; ++block) {
        for (Index row = 0; row < 3; ++row) matrix.innerIndexPtr()[place++] = 3 * lower[block] + row;
      }
    }
  }
  matrix.outerIndexPtr()[3 * vertexCount] = place;
  std::fill(matrix.valuePtr(), matrix.valuePtr() + place, 0.0);
  return matrix;
}

}  // namespace

VertexBlocks::VertexBlocks(const RestSurface& surface, const std::vector<PointRow>& rows) : ends_(surface.edges.ends) {
  collectPairs(surface, rows, start_, lower_);
  zero_ = zeroMatrix(start_, lower_);
  blockOf_.reserve(ends_.size());
  for (const auto& [low, high] : ends_) blockOf_.push_back(findBlock(high, low));
}

Index VertexBlocks::findBlock(Index low, Index column) const {
  const auto first = lower_.begin() + start_[column], last = lower_.begin() + start_[column + 1];
  return static_cast<Index>(std::lower_bound(first, last, low) - first);
}

void VertexBlocks::addBelow(Index row, Index column, Index block, const Mat3& B, double* values) const {
  if (row == column) return addDiagonal(row, B + B.transpose(), values);
  for (int axis = 0; axis < 3; ++axis) {
    double* const rows = columnOf(column, axis, values) + (3 - axis) + 3 * block;
    for (int i = 0; i < 3; ++i) rows[i] += B(i, axis);
  }
}

void VertexBlocks::addDiagonal(Index v, const Mat3& B, double* values) const {
  for (int axis = 0; axis < 3; ++axis) {
    double* const rows = columnOf(v, axis, values);
    for (int i = axis; i < 3; ++i) rows[i - axis] += B(i, axis);
  }
}

void VertexBlocks::addEdge(Index edge, const Mat3& K, double* values) const {
  const auto [low, high] = ends_[edge];
  addDiagonal(low, K, values);
  addDiagonal(high, K, values);
  addBelow(high, low, blockOf_[edge], -K, values);
}

}  // namespace whittle
