#include "constraints/handles.h"

#include <string>

namespace whittle {

Status validateHandles(const Handles& handles, Index vertexCount) {
  std::vector<bool> held(vertexCount, false);
  for (std::size_t h = 0; h < handles.vertices.size(); ++h) {
    const Index v = handles.vertices[h];
    const std::string name = "handle " + std::to_string(h) + " holds vertex " + std::to_string(v);
    if (v < 0 || v >= vertexCount) {
      return Status::failure(Code::badHandles, name + ", but there are only " + std::to_string(vertexCount), v);
    }
    if (held[v]) return Status::failure(Code::badHandles, name + ", which another handle holds already", v);
    if (!handles.targets.row(h).allFinite()) {
      return Status::failure(Code::badHandles, name + " at a place that is not a number", v);
    }
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
