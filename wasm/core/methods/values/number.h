#pragma once

#include "base/json.h"
#include "methods/values/raw_value.h"

namespace whittle {

/// Smallest and largest number that a parameter may have, both allowed.
struct Range {
  double min, max;

  bool holds(double value) const { return value >= min && value <= max; }
  void describe(Json& json) const { json.add("min", min).add("max", max); }
};

/// A number in a range: numbers [x].
struct NumberKind {
  using Value = double;
  static constexpr const char* kName = "number";
  Range range;

  Status read(const RawValue& raw, const MeshContext&, double& value) const {
    if (!raw.isNumbers(1)) return raw.refused("needs one number");
    if (!range.holds(raw.numbers[0])) return raw.refused("is out of its range");
    value = raw.numbers[0];
    return {};
  }
  void describe(double usual, Json& json) const { range.describe(json.add("default", usual)); }
};

}  // namespace whittle
