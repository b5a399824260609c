#pragma once

#include <cmath>

#include "methods/values/number.h"

namespace whittle {

/// A whole number in a range: numbers [x].
struct IntegerKind {
  using Value = int;
  static constexpr const char* kName = "integer";
  Range range;

  Status read(const RawValue& raw, const MeshContext&, int& value) const {
    if (!raw.isNumbers(1)) return raw.refused("needs one number");
    const double number = raw.numbers[0];
    if (!range.holds(number)) return raw.refused("is out of its range");
    if (number != std::trunc(number)) return raw.refused("must be a whole number");
    value = static_cast<int>(number);
    return {};
  }
  void describe(int usual, Json& json) const { range.describe(json.add("default", usual)); }
};

/// The kind of every limit of iterations.
inline constexpr IntegerKind kIterations{{0, 1e6}};

}  // namespace whittle
