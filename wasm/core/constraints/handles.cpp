#include "constraints/handles.h"

#include <string>

namespace whittle {

Status validateHandles(const Handles& handles, Index vertexCount) {
  std::vector<bool> held(vertexCount, false);
  for (std::size_t h = 0; h < handles.vertices.size(); ++h) {
    const Index v = handles.vertices[h];
    const auto refused = [&](const char* why) {
      return Status::failure(Code::badHandles, "handle " + std::to_string(h) + " holds vertex {}" + why,
                             Element::vertex(v));
    };
    if (v < 0 || v >= vertexCount) return refused(", which the mesh does not have");
    if (held[v]) return refused(", which another handle holds already");
    if (!handles.targets.row(h).allFinite()) return refused(" at a place that is not a number");
    held[v] = true;
  }
  return {};
}

void applyHandles(const Handles& handles, Points& positions) {
  for (std::size_t h = 0; h < handles.vertices.size(); ++h) {
    positions.row(handles.vertices[h]) = handles.targets.row(h);
  }
}

}  // namespace whittle
