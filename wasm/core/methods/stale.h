#pragma once

namespace whittle {

/// What a change of a parameter makes stale; each level includes those before it.
enum class Stale { nothing, targets, weights, system, all };

inline const char* staleName(Stale stale) {
  constexpr const char* kNames[] = {"nothing", "targets", "weights", "system", "all"};
  return kNames[static_cast<int>(stale)];
}

}  // namespace whittle
