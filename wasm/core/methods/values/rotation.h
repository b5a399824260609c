#pragma once

#include "base/json.h"
#include "methods/values/raw_value.h"

namespace whittle {

/// A quaternion x y z w of any length but zero.
using Quaternion = Eigen::Vector4d;

inline const Quaternion kIdentityQuaternion(0, 0, 0, 1);

/// A rotation: numbers x y z w.
struct RotationKind {
  using Value = Quaternion;
  static constexpr const char* kName = "rotation";

  Status read(const RawValue& raw, const MeshContext&, Quaternion& value) const {
    if (raw.isNumbers(4)) {
      const Quaternion q = Eigen::Map<const Quaternion>(raw.numbers.data());
      if (q.allFinite() && !q.isZero(0)) {
        value = q;
        return {};
      }
    }
    return raw.refused("must be a quaternion x y z w of finite numbers, not all of them zero");
  }
  void describe(const Quaternion& usual, Json& json) const { json.addJson("default", jsonList(usual, jsonNumber)); }
};

}  // namespace whittle
