#pragma once

#include <memory>

#include "base/json.h"
#include "methods/values/raw_value.h"
#include "targets/gauss_map.h"

namespace whittle {

/// A style's Gauss map. "closest": numbers are normals, #N×3. "vertex" and "face": indices are the count of the points,
/// then triangles #F×3; numbers are points, #P×3, then a normal for each point or triangle. None by default.
struct StyleKind {
  using Value = std::shared_ptr<const GaussMap>;
  static constexpr const char* kName = "style";

  Status read(const RawValue& raw, const MeshContext& mesh, Value& value) const;
  void describe(const Value&, Json&) const {}
};

EncodedValue encoded(const GaussMapData& data);

}  // namespace whittle
