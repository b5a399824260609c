#pragma once

#include "methods/values/number.h"

namespace whittle {

/// A fixed count of numbers, each in the same range: numbers [x, y, …].
template <int Size>
struct VectorKind {
  using Value = Eigen::Matrix<double, Size, 1>;
  static constexpr const char* kName = "vector";
  Range range;

  Status read(const RawValue& raw, const MeshContext&, Value& value) const {
    if (!raw.isNumbers(Size)) {
      return raw.refused("has " + std::to_string(raw.numbers.size()) + " numbers; it needs " + std::to_string(Size));
    }
    for (const double number : raw.numbers) {
      if (!range.holds(number)) return raw.refused("is out of its range");
    }
    value = Eigen::Map<const Value>(raw.numbers.data());
    return {};
  }
  void describe(const Value& usual, Json& json) const {
    range.describe(json.addJson("default", jsonList(usual, jsonNumber)));
  }
};

}  // namespace whittle
