#include "constraints/planes.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace whittle {

namespace {

/// How far beside a plane a handle is still on it.
constexpr double kOnPlane = 1e-9;

}  // namespace

Status validatePlanes(const Planes& planes, Index vertexCount) {
  for (std::size_t p = 0; p < planes.size(); ++p) {
    const std::string plane = "plane " + std::to_string(p);
    if (!planes[p].normal.allFinite() || planes[p].normal.isZero(0) || !std::isfinite(planes[p].offset))
      return Status::failure(Code::badPlanes, plane +
                                                  " has no direction or place; give it finite numbers, not all of "
                                                  "the normal's zero");
    for (const Index v : planes[p].vertices) {
      if (v >= 0 && v < vertexCount) continue;
      return Status::failure(Code::badPlanes, plane + " holds vertex {}, which the mesh does not have",
                             Element::vertex(v));
    }
  }
  std::vector<HeldRow> rows;
  const Status status = joinPlanes(rowPlanes(planes), rows);
  if (status.ok()) return status;
  return Status::failure(Code::badPlanes,
                         "vertex {} is on planes that have no point in common; take it off some of them",
                         Element::vertex(status.element.index));
}

Status validateHandlesOnPlanes(const Handles& handles, const Planes& planes) {
  if (planes.empty() || handles.vertices.empty()) return {};
  const Index highest = *std::max_element(handles.vertices.begin(), handles.vertices.end());
  std::vector<Index> handleOf(static_cast<std::size_t>(highest) + 1, -1);
  for (std::size_t h = 0; h < handles.vertices.size(); ++h) handleOf[handles.vertices[h]] = static_cast<Index>(h);
  for (std::size_t p = 0; p < planes.size(); ++p) {
    for (const Index v : planes[p].vertices) {
      if (v > highest || handleOf[v] < 0) continue;
      const double beside = planes[p].normal.dot(handles.targets.row(handleOf[v]).transpose()) - planes[p].offset;
      if (std::abs(beside) <= kOnPlane) continue;
      return Status::failure(Code::badPlanes,
                             "vertex {} is on plane " + std::to_string(p) +
                                 ", but a handle holds it beside that; move the handle's target onto the plane or let "
                                 "one of them go",
                             Element::vertex(v));
    }
  }
  return {};
}

std::vector<RowPlane> rowPlanes(const Planes& planes) {
  std::vector<RowPlane> rows;
  for (const auto& [vertices, normal, offset] : planes) {
    for (const Index v : vertices) rows.push_back({v, normal, offset});
  }
  return rows;
}

}  // namespace whittle
