#include "methods/values/scalars.h"

namespace whittle {

Status ScalarsKind::read(const RawValue& raw, const MeshContext& mesh, Scalars& value) const {
  if (!raw.isNumbers(static_cast<std::size_t>(mesh.vertexCount))) {
    return raw.refused("has " + std::to_string(raw.numbers.size()) + " numbers for " +
                       std::to_string(mesh.vertexCount) + " vertices");
  }
  for (Index v = 0; v < mesh.vertexCount; ++v) {
    if (!range.holds(raw.numbers[v])) return raw.refused("is out of its range at vertex {}", Element::vertex(v));
  }
  value = Eigen::Map<const Scalars>(raw.numbers.data(), mesh.vertexCount);
  return {};
}

Stale ScalarsKind::changed(const Scalars& before, const Scalars& now, Stale invalidates) const {
  return before.size() == now.size() && before == now ? Stale::nothing : invalidates;
}

}  // namespace whittle
