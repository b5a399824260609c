#pragma once

#include <memory>

#include "base/json.h"
#include "methods/values/raw_value.h"
#include "targets/texture_normals.h"

namespace whittle {

/// A texture's slopes: numbers are texture coordinates, then slopes, both 3·#F×2. None by default.
struct TextureSlopesKind {
  using Value = std::shared_ptr<const TextureSlopes>;
  static constexpr const char* kName = "textureSlopes";

  Status read(const RawValue& raw, const MeshContext& mesh, Value& value) const;
  void describe(const Value&, Json&) const {}
};

EncodedValue encoded(const TextureSlopes& texture);

}  // namespace whittle
