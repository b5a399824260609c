#pragma once

#include "methods/stale.h"
#include "methods/values/number.h"
#include "methods/vertex_order.h"

namespace whittle {

/// A number for each vertex, in a range: #V numbers. None by default.
struct ScalarsKind {
  using Value = Scalars;
  static constexpr const char* kName = "scalars";
  Range range;

  Status read(const RawValue& raw, const MeshContext& mesh, Scalars& value) const;
  void describe(const Scalars&, Json& json) const { range.describe(json); }
  Stale changed(const Scalars& before, const Scalars& now, Stale invalidates) const;
  void order(const VertexOrder& order, Scalars& value) const { value = order.orderedRows(value); }
};

}  // namespace whittle
