#include "geometry/box_tree.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace whittle {

BoxTree::BoxTree(std::vector<Box> boxes) : boxes_(std::move(boxes)), indices_(boxes_.size()) {
  std::iota(indices_.begin(), indices_.end(), 0);
  Node root{{}, 0, static_cast<Index>(boxes_.size())};
  for (const Box& box : boxes_) root.box.extend(box);
  nodes_.push_back(root);
  if (root.end > kLeaf) open_.push_back(0);
}

bool BoxTree::buildNext(std::size_t work) {
  std::size_t moved = 0;
  while (!open_.empty() && moved < work) {
    const Index node = open_.back();
    open_.pop_back();
    moved += nodes_[node].end - nodes_[node].first;
    cut(node);
  }
  return open_.empty();
}

void BoxTree::cut(Index node) {
  const Index first = nodes_[node].first, end = nodes_[node].end, count = end - first;
  int axis = 0;
  nodes_[node].box.sizes().maxCoeff(&axis);
  // Halves of the same number of boxes: the tree is as deep as it has to be, whatever the shape.
  std::vector<std::pair<double, Index>> keys(count);
  for (Index i = 0; i < count; ++i) keys[i] = {boxes_[first + i].center()[axis], i};
  std::nth_element(keys.begin(), keys.begin() + count / 2, keys.end());
  std::vector<Index> indices(count);
  std::vector<Box> boxes(count);
  for (Index i = 0; i < count; ++i) {
    indices[i] = indices_[first + keys[i].second];
    boxes[i] = boxes_[first + keys[i].second];
  }
  std::copy(indices.begin(), indices.end(), indices_.begin() + first);
  std::copy(boxes.begin(), boxes.end(), boxes_.begin() + first);

  nodes_[node].child = static_cast<Index>(nodes_.size());
  for (const auto& [from, to] : {std::pair(first, first + count / 2), std::pair(first + count / 2, end)}) {
    Node half{{}, from, to};
    for (Index i = from; i < to; ++i) half.box.extend(boxes_[i]);
    if (to - from > kLeaf) open_.push_back(static_cast<Index>(nodes_.size()));
    nodes_.push_back(half);
  }
}

}  // namespace whittle
