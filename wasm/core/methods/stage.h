#pragma once

#include <functional>
#include <type_traits>
#include <vector>

#include "base/status.h"
#include "methods/stale.h"

namespace whittle {

/// A piece of preparing, between which and the next a caller may think again.
struct Stage {
  Stale level;        // what is no longer stale once all stages of this level are done
  const char* doing;  // in a few words for people, e.g. "factoring the system"
  double weight;      // about how long it takes, in any unit that all stages of a preparation share
  /// Does some of it. `done` comes as 1 and is left there by what is done in one go; otherwise it becomes the share
  /// that is done, and the rest waits for further calls.
  std::function<Status(double& done)> run;
};

/// The stages of a preparation that refresh what is stale, to be added with the highest level first.
class Plan {
 public:
  explicit Plan(Stale stale) : stale_(stale) {}

  /// Adds a stage if its level is stale.
  /// @param work takes nothing where it is done in one go, and else `done`; returns a `Status` where it can fail
  template <typename Work>
  Plan& add(Stale level, const char* doing, double weight, Work work) {
    if (stale_ < level) return *this;
    stages_.push_back({level, doing, weight, [work]([[maybe_unused]] double& done) -> Status {
                         if constexpr (std::is_invocable_r_v<Status, Work, double&>) {
                           return work(done);
                         } else if constexpr (std::is_invocable_v<Work, double&>) {
                           work(done);
                         } else {
                           work();
                         }
                         return {};
                       }});
    return *this;
  }
  /// Adds stages of which each has found that its level is stale.
  Plan& add(const std::vector<Stage>& stages) {
    stages_.insert(stages_.end(), stages.begin(), stages.end());
    return *this;
  }

  const std::vector<Stage>& stages() const { return stages_; }

 private:
  Stale stale_;
  std::vector<Stage> stages_;
};

}  // namespace whittle
