#pragma once

#include "base/json.h"
#include "constraints/straight_chains.h"
#include "methods/values/raw_value.h"
#include "methods/vertex_order.h"

namespace whittle {

/// Lines over the mesh, each a list of vertices: indices are, chain by chain, how many vertices it has and these. None
/// by default.
struct ChainsKind {
  using Value = VertexChains;
  static constexpr const char* kName = "chains";

  Status read(const RawValue& raw, const MeshContext& mesh, VertexChains& value) const;
  void describe(const VertexChains&, Json&) const {}
  void order(const VertexOrder& order, VertexChains& value) const;
};

/// Encodes chains.
EncodedValue encoded(const VertexChains& chains);

}  // namespace whittle
