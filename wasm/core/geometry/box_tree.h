#pragma once

#include <utility>
#include <vector>

#include "mesh/bounding_box.h"

namespace whittle {

/// A tree of boxes, for finding those that meet another, or are near a point. Built slice by slice.
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

  /// Calls `visit(i)` for boxes that are nearer to a point than `reach`, a squared distance; visit returns the reach
  /// from then on. Near boxes come early, so that what they hold soon rules out the others. Allocates nothing.
  template <typename Visit>
  void findNear(const Vec3& point, double reach, Visit&& visit) const {
    struct Open {
      Index node;
      double distance;
    } stack[kMostDepth];
    int depth = 0;
    stack[depth++] = {0, 0};
    while (depth > 0) {
      const auto [place, away] = stack[--depth];
      if (away >= reach) continue;
      const Node& node = nodes_[place];
      if (node.child >= 0) {
        Open near{node.child, nodes_[node.child].box.squaredExteriorDistance(point)};
        Open far{node.child + 1, nodes_[node.child + 1].box.squaredExteriorDistance(point)};
        if (far.distance < near.distance) std::swap(near, far);
        stack[depth++] = far;
        stack[depth++] = near;
        continue;
      }
      for (Index i = node.first; i < node.end; ++i) {
        if (boxes_[i].squaredExteriorDistance(point) < reach) reach = visit(indices_[i]);
      }
    }
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
