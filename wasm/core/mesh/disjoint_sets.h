#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include "base/types.h"

namespace whittle {

/// Sets of 0 … count − 1 that grow together, the smallest member standing for each.
class DisjointSets {
 public:
  explicit DisjointSets(Index count = 0) { reset(count); }

  /// Makes each a set of its own. Claims memory only for more than there ever were.
  void reset(Index count) {
    parent_.resize(count);
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  Index find(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];  // halves the path: long strips stay linear
    return i;
  }

  /// Joins the sets of two; returns whether they were apart.
  bool join(Index i, Index j) {
    const Index a = find(i), b = find(j);
    parent_[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

 private:
  std::vector<Index> parent_;
};

}  // namespace whittle
