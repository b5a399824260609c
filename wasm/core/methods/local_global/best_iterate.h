#pragma once

#include <limits>
#include <string>

#include "base/types.h"

namespace whittle {

/// The iterate of least energy of a run whose energy may rise, to fall back on where it ends above what it began with.
/// The start itself is not among them: it would be no result.
class BestIterate {
 public:
  /// @param isKept whether there is to be one; claims its memory
  void begin(bool isKept, const Points& positions) {
    isKept_ = isKept;
    wasTaken_ = false;
    iteration_ = best_ = 0;
    least_ = std::numeric_limits<double>::infinity();
    if (isKept) positions_ = positions;
  }
  /// Looks at an iterate of which the energy is known. Allocates nothing.
  void offer(const Points& positions, double energy) {
    if (!isKept_) return;
    if (iteration_++ == 0) {
      first_ = energy;
    } else if (energy < least_) {
      least_ = energy;
      best_ = iteration_ - 1;
      positions_ = positions;
    }
    last_ = energy;
  }
  /// Takes the best one if the run has ended above its beginning; returns whether it did.
  bool take(Points& positions) {
    constexpr double kRise = 1e-6;  // what single precision may do
    wasTaken_ = isKept_ && best_ > 0 && last_ > first_ * (1 + kRise) && least_ < last_;
    if (wasTaken_) positions = positions_;
    return wasTaken_;
  }
  bool wasTaken() const { return wasTaken_; }
  /// Iterations that made it.
  int iteration() const { return best_; }

 private:
  bool isKept_ = false, wasTaken_ = false;
  int iteration_ = 0, best_ = 0;
  double first_ = 0, last_ = 0, least_ = 0;
  Points positions_;  // #V×3
};

}  // namespace whittle
