#pragma once

#include <optional>
#include <vector>

#include "base/types.h"

namespace whittle {

/// How many times the moves of the handles of one gesture are those of another: nothing where they are no straight
/// continuation of it, or lead much farther than that one went.
std::optional<double> shareOfGesture(const std::vector<Vec3>& before, const std::vector<Vec3>& now);

}  // namespace whittle
