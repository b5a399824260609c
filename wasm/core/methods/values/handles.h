#pragma once

#include "base/json.h"
#include "constraints/handles.h"
#include "methods/stale.h"
#include "methods/values/raw_value.h"
#include "methods/vertex_order.h"

namespace whittle {

/// Vertices held at places: indices are the vertices, numbers their targets, 3 each in the file's units; kept in the unit
/// frame. Vertices at the end for which there are no numbers are held where they are. None by default.
struct HandlesKind {
  using Value = Handles;
  static constexpr const char* kName = "handles";

  /// Fails as `validateHandles` does.
  Status read(const RawValue& raw, const MeshContext& mesh, Handles& value) const;
  void describe(const Handles&, Json&) const {}
  /// Other targets for the same vertices leave the system as it is.
  Stale changed(const Handles& before, const Handles& now, Stale invalidates) const;
  void order(const VertexOrder& order, Handles& value) const;
};

/// Encodes handles with targets in the file's units.
EncodedValue encoded(const Handles& handles);

}  // namespace whittle
