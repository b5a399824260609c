#pragma once

#include "base/json.h"
#include "methods/stale.h"
#include "methods/values/raw_value.h"
#include "methods/vertex_order.h"

namespace whittle {

/// A quaternion x y z w for each vertex (#V×4).
using Quaternions = Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor>;

/// A rotation for each vertex: 4·#V numbers, x y z w each; a quaternion of zeros says nothing of its vertex. None by
/// default.
struct RotationsKind {
  using Value = Quaternions;
  static constexpr const char* kName = "rotations";

  Status read(const RawValue& raw, const MeshContext& mesh, Quaternions& value) const;
  void describe(const Quaternions&, Json&) const {}
  Stale changed(const Quaternions& before, const Quaternions& now, Stale invalidates) const;
  void order(const VertexOrder& order, Quaternions& value) const { value = order.orderedRows(value); }
};

}  // namespace whittle
