#pragma once

#include "base/json.h"
#include "methods/values/raw_value.h"

namespace whittle {

/// Something that is done or not: numbers [0] or [1].
struct FlagKind {
  using Value = bool;
  static constexpr const char* kName = "flag";

  Status read(const RawValue& raw, const MeshContext&, bool& value) const {
    if (!raw.isNumbers(1) || (raw.numbers[0] != 0 && raw.numbers[0] != 1)) return raw.refused("must be 0 or 1");
    value = raw.numbers[0] != 0;
    return {};
  }
  void describe(bool usual, Json& json) const { json.addJson("default", usual ? "true" : "false"); }
};

}  // namespace whittle
