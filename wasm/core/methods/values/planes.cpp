#include "methods/values/planes.h"

#include <algorithm>

namespace whittle {

namespace {

/// The plane of file coordinates in the unit frame, with a normal of length 1 if it has a direction.
void takeToUnit(const UnitFrame& frame, Plane& plane) {
  const double length = plane.normal.stableNorm();
  if (!(length > 0)) return;
  plane.normal /= length;
  plane.offset = (plane.offset / length - plane.normal.dot(frame.center)) / frame.scale;
}

}  // namespace

Status PlanesKind::read(const RawValue& raw, const MeshContext& mesh, Planes& value) const {
  Planes planes;
  std::size_t first = 0;
  while (first < raw.indices.size() && raw.indices[first] >= 0) {
    const std::size_t end = first + 1 + static_cast<std::size_t>(raw.indices[first]);
    if (end > raw.indices.size() || 4 * planes.size() + 4 > raw.numbers.size()) break;
    const double* const numbers = raw.numbers.data() + 4 * planes.size();
    planes.push_back({{raw.indices.begin() + static_cast<std::ptrdiff_t>(first) + 1,
                       raw.indices.begin() + static_cast<std::ptrdiff_t>(end)},
                      Eigen::Map<const Vec3>(numbers),
                      numbers[3]});
    takeToUnit(mesh.frame, planes.back());
    first = end;
  }
  if (raw.hasName() || first != raw.indices.size() || 4 * planes.size() != raw.numbers.size())
    return raw.refused("must have for each plane its count of vertices, these, a normal and an offset");
  if (Status status = validatePlanes(planes, mesh.vertexCount); !status.ok()) return status;
  value = std::move(planes);
  return {};
}

Stale PlanesKind::changed(const Planes& before, const Planes& now, Stale invalidates) const {
  const bool isSystem =
      std::equal(before.begin(), before.end(), now.begin(), now.end(),
                 [](const Plane& a, const Plane& b) { return a.vertices == b.vertices && a.normal == b.normal; });
  if (!isSystem) return invalidates;
  return before == now ? Stale::nothing : Stale::targets;
}

void PlanesKind::order(const VertexOrder& order, Planes& value) const {
  for (Plane& plane : value) {
    for (Index& v : plane.vertices) v = order.placeOf(v);
  }
}

EncodedValue encoded(const Planes& planes) {
  EncodedValue value;
  for (const auto& [vertices, normal, offset] : planes) {
    value.indices.push_back(static_cast<Index>(vertices.size()));
    value.indices.insert(value.indices.end(), vertices.begin(), vertices.end());
    value.append(normal);
    value.numbers.push_back(offset);
  }
  return value;
}

}  // namespace whittle
