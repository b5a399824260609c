#include "methods/alternating/reshape_rows.h"

#include "mesh/disjoint_sets.h"

namespace whittle {

namespace {

constexpr double kHandles = 1e5;    // w_constr
constexpr double kStraight = 1e5;   // w_straight
constexpr double kScaffold = 1e-2;  // w_edge
/// Of ties between parts that touch, against the 1 / l̄² that an edge of mean length has.
constexpr double kTies = 1e3;

}  // namespace

PointRow handleRow(const TriangleMesh& input, const DerivedMesh& working, const Transfer& transfer, Index vertex) {
  const Transfer::Place& place = transfer.place(vertex);
  PointRow row;
  row.stiffness = kHandles;
  if (place.twin >= 0) {
    row.add(place.twin, 1);
  } else if (place.face >= 0) {
    for (int k = 0; k < 3; ++k) {
      if (place.weights[k] != 0) row.add(working.mesh.triangles(place.face, k), place.weights[k]);
    }
  }
  row.target = input.positions.row(vertex).transpose();
  return row;
}

void addStraightRows(const VertexChains& chains, Straightness straightness, const Points& rest,
                     std::vector<PointRow>& rows) {
  for (const std::vector<Index>& chain : chains) {
    for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
      const double before = (rest.row(chain[i]) - rest.row(chain[i - 1])).norm();
      const double after = (rest.row(chain[i + 1]) - rest.row(chain[i])).norm();
      if (before == 0 || after == 0) continue;
      PointRow row;
      row.stiffness = kStraight;
      row.add(chain[i + 1], 1 / after);
      row.add(chain[i], -1 / after - 1 / before);
      row.add(chain[i - 1], 1 / before);
      if (straightness == Straightness::asAtRest) row.target = row.residual(rest);
      rows.push_back(row);
    }
  }
}

void addAttachmentRows(const std::vector<Attachment>& attachments, const Points& rest, std::vector<PointRow>& rows) {
  for (const Attachment& attachment : attachments) {
    PointRow row;
    row.stiffness = kTies;
    for (int i = 0; i < Attachment::kMost; ++i) {
      if (attachment.weights[i] != 0) row.add(attachment.vertices[i], attachment.weights[i]);
    }
    row.target = row.residual(rest);
    rows.push_back(row);
  }
}

void addScaffoldRows(const Scaffold& scaffold, const Points& rest, std::vector<PointRow>& rows) {
  for (const auto& [first, second, length] : scaffold.betweenParts) {
    PointRow row;
    row.stiffness = kScaffold / (length * length);
    row.add(first, -1);
    row.add(second, 1);
    row.target = row.residual(rest);
    rows.push_back(row);
  }
}

void addPins(const RestSurface& surface, const std::vector<PointRow>& handles, std::vector<PointRow>& rows) {
  DisjointSets parts(surface.vertexCount());
  const auto join = [&](const PointRow& row) {
    for (int i = 1; i < row.count; ++i) parts.join(row.vertices[0], row.vertices[i]);
  };
  for (const auto& [low, high] : surface.edges.ends) parts.join(low, high);
  for (const PointRow& row : rows) join(row);
  std::vector<bool> isHeld(surface.vertexCount(), false);
  for (const PointRow& row : handles) {
    if (row.count > 0) isHeld[parts.find(row.vertices[0])] = true;
  }
  for (Index v = 0; v < surface.vertexCount(); ++v) {
    if (parts.find(v) != v || isHeld[v]) continue;
    PointRow pin;
    pin.stiffness = kHandles;
    pin.add(v, 1);
    pin.target = surface.mesh.positions.row(v).transpose();
    rows.push_back(pin);
  }
}

}  // namespace whittle
