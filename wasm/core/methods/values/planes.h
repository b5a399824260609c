#pragma once

#include "base/json.h"
#include "constraints/planes.h"
#include "methods/stale.h"
#include "methods/values/raw_value.h"
#include "methods/vertex_order.h"

namespace whittle {

/// Vertices held on planes: indices are, plane by plane, how many vertices it holds and these; numbers the planes'
/// normals, of any length but zero, and offsets, 4 each in the file's units; kept in the unit frame. None by default.
struct PlanesKind {
  using Value = Planes;
  static constexpr const char* kName = "planes";

  /// Fails as `validatePlanes` does.
  Status read(const RawValue& raw, const MeshContext& mesh, Planes& value) const;
  void describe(const Planes&, Json&) const {}
  /// Planes that are shifted leave the system as it is.
  Stale changed(const Planes& before, const Planes& now, Stale invalidates) const;
  void order(const VertexOrder& order, Planes& value) const;
};

/// Encodes planes with offsets in the file's units.
EncodedValue encoded(const Planes& planes);

}  // namespace whittle
