#pragma once

#include <vector>

#include "methods/stage.h"

namespace whittle {

/// A preparation on its way: stages, done one call at a time.
class Preparation {
 public:
  explicit Preparation(std::vector<Stage> stages) : stages_(std::move(stages)) {}

  /// Does the next stage, or some of it. After a failure nothing more is to be done.
  Status advance();

  bool isDone() const { return next_ == stages_.size(); }
  /// What `advance` does next, in a few words for people; "" when all is done.
  const char* doing() const { return isDone() ? "" : stages_[next_].doing; }
  /// The level that is still stale, with all below.
  Stale stale() const { return isDone() ? Stale::nothing : stages_[next_].level; }
  /// How far it is, 0 to 1.
  double share() const;

 private:
  std::vector<Stage> stages_;
  std::size_t next_ = 0;
  double done_ = 0;  // of the next
};

}  // namespace whittle
