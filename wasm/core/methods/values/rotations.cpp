#include "methods/values/rotations.h"

namespace whittle {

Status RotationsKind::read(const RawValue& raw, const MeshContext& mesh, Quaternions& value) const {
  if (!raw.isNumbers(4 * static_cast<std::size_t>(mesh.vertexCount))) {
    return raw.refused("has " + std::to_string(raw.numbers.size()) + " numbers for " +
                       std::to_string(mesh.vertexCount) + " vertices; it needs four for each");
  }
  const Eigen::Map<const Quaternions> given(raw.numbers.data(), mesh.vertexCount, 4);
  for (Index v = 0; v < mesh.vertexCount; ++v) {
    if (!given.row(v).allFinite()) return raw.refused("is not finite at vertex {}", Element::vertex(v));
  }
  value = given;
  return {};
}

Stale RotationsKind::changed(const Quaternions& before, const Quaternions& now, Stale invalidates) const {
  return before.rows() == now.rows() && before == now ? Stale::nothing : invalidates;
}

}  // namespace whittle
