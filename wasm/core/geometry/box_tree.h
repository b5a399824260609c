#pragma once

#include <vector>

#include "mesh/bounding_box.h"

namespace whittle {

/// A tree of boxes, for finding those that meet another. Built slice by slice.
class BoxTree {
 public:
  explicit BoxTree(std::vector<Box> boxes);

  /// Cuts nodes until about `work` boxes were moved or all is done; returns whether all is done.
  bool buildNext(std::size_t work);

  /// Calls `visit(i)` for each box i, in the order in which they were given, that meets a box, until one says that it
  /// has seen enough (true). Allocates nothing. Returns whether one did.
  template <typename Visit>
  bool findIn(const Box& box, Visit&& visit) const {
    Index stack[kMostDepth];
    int depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
      const Node& node = nodes_[stack[--depth]];
      if (!node.box.intersects(box)) continue;
      if (node.child >= 0) {
        stack[depth++] = node.child;
        stack[depth++] = node.child + 1;
        continue;
      }
      for (Index i = node.first; i < node.end; ++i) {
        if (boxes_[i].intersects(box) && visit(indices_[i])) return true;
      }
    }
    return false;
  }

 private:
  struct Node {
    Box box;
    Index first, end;  // of its boxes
    Index child = -1;  // the first of two, or −1: a leaf
  };
  static constexpr Index kLeaf = 4;
  static constexpr int kMostDepth = 64;

  void cut(Index node);

  std::vector<Box> boxes_;
  std::vector<Index> indices_;  // of `boxes_`, as they were given
  std::vector<Node> nodes_;     // the root first
  std::vector<Index> open_;     // nodes that are not cut yet
};

}  // namespace whittle
