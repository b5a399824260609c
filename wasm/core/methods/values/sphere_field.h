#pragma once

#include <memory>

#include "base/json.h"
#include "methods/values/raw_value.h"
#include "targets/sphere_field.h"

namespace whittle {

/// A field over the sphere of directions: indices are width and height of its picture, numbers what it holds, rows from
/// the top. None by default.
struct SphereFieldKind {
  using Value = std::shared_ptr<const SphereField>;
  static constexpr const char* kName = "sphereField";

  /// Fails as `validateSphereField` does.
  Status read(const RawValue& raw, const MeshContext&, Value& value) const;
  void describe(const Value&, Json&) const {}
};

EncodedValue encoded(const SphereField& field);

}  // namespace whittle
