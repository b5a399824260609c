#include "methods/values/handles.h"

namespace whittle {

Status HandlesKind::read(const RawValue& raw, const MeshContext& mesh, Handles& value) const {
  if (raw.hasName() || raw.numbers.size() % 3 != 0 || raw.numbers.size() > 3 * raw.indices.size())
    return raw.refused("must have targets of three numbers, and no more of them than vertices");
  Handles handles{std::vector<Index>(raw.indices.begin(), raw.indices.end()),
                  Points::Zero(static_cast<Index>(raw.indices.size()), 3)};
  const Index moved = static_cast<Index>(raw.numbers.size() / 3);
  handles.targets.topRows(moved) = Eigen::Map<const Points>(raw.numbers.data(), moved, 3);
  if (Status status = validateHandles(handles, mesh.vertexCount); !status.ok()) return status;
  for (Index h = moved; h < handles.targets.rows(); ++h)
    handles.targets.row(h) = mesh.positions->row(handles.vertices[h]);
  for (Index h = 0; h < handles.targets.rows(); ++h) {
    handles.targets.row(h) = mesh.frame.toUnit(handles.targets.row(h).transpose()).transpose();
  }
  value = std::move(handles);
  return {};
}

Stale HandlesKind::changed(const Handles& before, const Handles& now, Stale invalidates) const {
  if (before.vertices != now.vertices) return invalidates;
  return before.targets == now.targets ? Stale::nothing : Stale::targets;
}

void HandlesKind::order(const VertexOrder& order, Handles& value) const {
  for (Index& v : value.vertices) v = order.placeOf(v);
}

EncodedValue encoded(const Handles& handles) {
  EncodedValue value;
  value.indices = handles.vertices;
  value.append(handles.targets);
  return value;
}

}  // namespace whittle
