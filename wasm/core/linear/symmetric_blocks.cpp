#include "linear/symmetric_blocks.h"

#include <algorithm>

namespace whittle {

SymmetricBlocks::SymmetricBlocks(Index nodes, std::vector<std::array<Index, 2>> pairs) {
  for (std::array<Index, 2>& pair : pairs) {
    if (pair[0] > pair[1]) std::swap(pair[0], pair[1]);
  }
  for (Index node = 0; node < nodes; ++node) pairs.push_back({node, node});
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  start_.assign(nodes + 1, 0);
  for (const auto& pair : pairs) ++start_[pair[0] + 1];
  for (Index node = 0; node < nodes; ++node) start_[node + 1] += start_[node];
  for (const auto& pair : pairs) rows_.push_back(pair[1]);

  matrix_.resize(3 * nodes, 3 * nodes);
  matrix_.resizeNonZeros(9 * static_cast<Index>(rows_.size()));
  matrix_.outerIndexPtr()[0] = 0;
  for (Index node = 0; node < nodes; ++node) {
    const Index count = start_[node + 1] - start_[node];
    for (int column = 0; column < 3; ++column) {
      const Index first = 9 * start_[node] + 3 * count * column;
      for (Index i = 0; i < 3 * count; ++i)
        matrix_.innerIndexPtr()[first + i] = 3 * rows_[start_[node] + i / 3] + i % 3;
      matrix_.outerIndexPtr()[3 * node + column + 1] = first + 3 * count;
    }
    for (Index i = 0; i < count; ++i) places_.push_back({9 * start_[node] + 3 * i, 3 * count});
  }
  setZero();
}

Index SymmetricBlocks::place(Index node, Index other) const {
  const Index low = std::min(node, other), high = std::max(node, other);
  const auto first = rows_.begin() + start_[low], last = rows_.begin() + start_[low + 1];
  return static_cast<Index>(std::lower_bound(first, last, high) - rows_.begin());
}

}  // namespace whittle
