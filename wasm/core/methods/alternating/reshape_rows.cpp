#include "methods/alternating/reshape_rows.h"

#include <algorithm>

#include "mesh/disjoint_sets.h"

namespace whittle {

namespace {

constexpr double kHandles = 1e5;   // w_constr
constexpr double kStraight = 1e5;  // w_straight
/// Of rows that count across a line only: they are stiff one way and not the other, which costs iterations, and lines
/// bend no more with this than with more.
constexpr double kStraightAcross = 30;
constexpr double kScaffold = 1e-2;  // w_edge
/// Parts farther from each other than this, in the unit frame, have nothing to do with each other.
constexpr double kFarApart = 10;
/// Of ties between parts that touch, against the 1 / l̄² that an edge of mean length has.
constexpr double kTies = 1e3;

/// A half edge along the edge between two vertices, or −1.
Index halfEdgeBetween(const RestSurface& surface, Index v, Index w) {
  const std::array<Index, 2> ends = {std::min(v, w), std::max(v, w)};
  const auto& all = surface.edges.ends;
  const auto found = std::lower_bound(all.begin(), all.end(), ends);
  return found != all.end() && *found == ends ? surface.edges.halfEdges[surface.edges.start[found - all.begin()]] : -1;
}

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

void addStraightRows(const VertexChains& chains, const Straightness& straightness, const RestSurface& surface,
                     std::vector<PointRow>& rows) {
  const Points& rest = surface.mesh.positions;
  for (const std::vector<Index>& chain : chains) {
    for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
      const double before = (rest.row(chain[i]) - rest.row(chain[i - 1])).norm();
      const double after = (rest.row(chain[i + 1]) - rest.row(chain[i])).norm();
      if (before == 0 || after == 0) continue;
      PointRow row;
      row.stiffness = kStraight;
      for (const Index v : {chain[i + 1], chain[i], chain[i - 1]}) row.add(v, 0);
      row.setLineLengths(after, before);
      if (straightness.isAcross) {
        row.stiffness = kStraightAcross;
        row.counts = PointRow::Counts::across;
        row.direction = (rest.row(chain[i + 1]) - rest.row(chain[i - 1])).transpose().stableNormalized();
      }
      if (straightness.asAtRest) row.target = row.residual(rest);
      const Index next = halfEdgeBetween(surface, chain[i], chain[i + 1]);
      const Index last = halfEdgeBetween(surface, chain[i - 1], chain[i]);
      if (next >= 0 && last >= 0) row.halfEdges = {next, last};
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
    if (length > kFarApart) continue;
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
