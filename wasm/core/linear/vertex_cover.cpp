#include "linear/vertex_cover.h"

namespace whittle {

namespace {

constexpr Index kNone = -1;

}  // namespace

// Hopcroft and Karp: rounds of shortest augmenting paths, breadth first for their length, then depth first along them.
Index VertexCover::find(const std::vector<Index>& start, const std::vector<Index>& neighbours, Index rightCount) {
  const Index leftCount = static_cast<Index>(start.size()) - 1;
  start_ = start.data();
  neighbours_ = neighbours.data();
  mateOfLeft_.assign(leftCount, kNone);
  mateOfRight_.assign(rightCount, kNone);
  depth_.resize(leftCount);
  next_.resize(leftCount);
  Index matched = 0;
  while (layer()) {
    next_.assign(start.begin(), start.end() - 1);
    for (Index left = 0; left < leftCount; ++left) {
      if (mateOfLeft_[left] == kNone && augment(left)) ++matched;
    }
  }
  // The last layering met no augmenting path: the cover is what it reached on the right and did not reach on the left.
  return matched;
}

/// Reaches what alternating paths from unmatched left nodes reach. Says whether one of them ends unmatched.
bool VertexCover::layer() {
  const Index leftCount = static_cast<Index>(mateOfLeft_.size());
  reached_.assign(mateOfRight_.size(), 0);
  queue_.clear();
  for (Index left = 0; left < leftCount; ++left) {
    depth_[left] = mateOfLeft_[left] == kNone ? 0 : kNone;
    if (depth_[left] == 0) queue_.push_back(left);
  }
  bool open = false;
  for (std::size_t head = 0; head < queue_.size(); ++head) {
    const Index left = queue_[head];
    for (Index p = start_[left]; p < start_[left + 1]; ++p) {
      const Index right = neighbours_[p];
      if (reached_[right]) continue;
      reached_[right] = 1;
      const Index mate = mateOfRight_[right];
      if (mate == kNone) {
        open = true;
      } else if (depth_[mate] == kNone) {
        depth_[mate] = depth_[left] + 1;
        queue_.push_back(mate);
      }
    }
  }
  return open;
}

/// Follows layers from an unmatched left node to an unmatched right one and swaps the matching along the way.
bool VertexCover::augment(Index root) {
  queue_.assign(1, root);  // the path so far
  while (!queue_.empty()) {
    const Index left = queue_.back();
    if (next_[left] == start_[left + 1]) {
      queue_.pop_back();
      if (!queue_.empty()) ++next_[queue_.back()];
      continue;
    }
    const Index mate = mateOfRight_[neighbours_[next_[left]]];
    if (mate == kNone) {
      for (const Index node : queue_) {
        const Index right = neighbours_[next_[node]];
        mateOfLeft_[node] = right;
        mateOfRight_[right] = node;
        ++next_[node];
      }
      return true;
    }
    if (depth_[mate] == depth_[left] + 1) {
      queue_.push_back(mate);
    } else {
      ++next_[left];
    }
  }
  return false;
}

}  // namespace whittle
