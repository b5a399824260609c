#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "simd/lanes.h"

namespace whittle {

/// When the rotations of vertices are searched for again. Above a λ of about 3 more and more of them have a duality gap:
/// no certificate can tell a global maximum, and a search costs as much as dozens of climbs. Where it finds what the
/// climb from the last answer finds, it is made ever more rarely: after 4, 16 and then 64 further iterations.
class SearchSchedule {
 public:
  void begin(std::size_t batches) { states_.assign(batches, State{}); }

  /// The lanes that have had a gap; they need no certificate.
  LaneMask open(std::size_t batch) const {
    LaneMask mask{};
    for (int lane = 0; lane < 4; ++lane) mask[lane] = states_[batch].pause[lane] > 0 ? -1 : 0;
    return mask;
  }
  /// Closes the gaps of certified lanes, counts the others' iteration and says which of them are to be searched.
  LaneMask due(std::size_t batch, LaneMask certified) {
    LaneMask mask{};
    State& state = states_[batch];
    for (int lane = 0; lane < 4; ++lane) {
      if (certified[lane]) {
        close(batch, lane);
      } else if (state.wait[lane] > 0) {
        --state.wait[lane];
      } else {
        mask[lane] = -1;
      }
    }
    return mask;
  }
  /// Notes that there is no gap.
  void close(std::size_t batch, int lane) { states_[batch].pause[lane] = states_[batch].wait[lane] = 0; }
  /// Notes a gap, and whether the search found more than the climb.
  void searched(std::size_t batch, int lane, bool paid) {
    State& state = states_[batch];
    std::uint8_t& pause = state.pause[lane];
    pause = paid || pause == 0 ? kShortestPause : std::min<std::uint8_t>(4 * pause, kLongestPause);
    state.wait[lane] = pause;
  }

 private:
  static constexpr std::uint8_t kShortestPause = 4, kLongestPause = 64;
  struct State {
    std::uint8_t pause[4] = {0, 0, 0, 0};  // iterations between two searches; 0 without a gap
    std::uint8_t wait[4] = {0, 0, 0, 0};   // iterations to the next one
  };
  std::vector<State> states_;
};

}  // namespace whittle
