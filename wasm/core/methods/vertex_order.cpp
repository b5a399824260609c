#include "methods/vertex_order.h"

#include "linear/elimination_tree.h"
#include "linear/ordering.h"
#include "mesh/adjacency.h"

namespace whittle {

namespace {

/// The vertices and edges of a mesh.
Graph edgeGraph(const TriangleMesh& mesh) {
  const Fans fans(mesh.triangles, mesh.vertexCount());
  std::vector<Index> lastSeen(mesh.vertexCount(), -1);
  std::vector<std::pair<Index, Index>> edges;
  edges.reserve(mesh.triangles.size());
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    for (Index p = fans.start[v]; p < fans.start[v + 1]; ++p) {
      for (const int other : kOtherCorners[fans.corners[p] % 3]) {
        const Index w = mesh.triangles(fans.corners[p] / 3, other);
        if (w <= v || lastSeen[w] == v) continue;
        lastSeen[w] = v;
        edges.emplace_back(v, w);
      }
    }
  }
  return graphOf(mesh.vertexCount(), edges);
}

/// @param moved where a vertex goes
/// @param from where the vertex comes from that is to stand at a place
template <typename Moved, typename From>
TriangleMesh renumbered(const TriangleMesh& mesh, const Moved& moved, const From& from) {
  TriangleMesh result{Points(mesh.vertexCount(), 3), Triangles(mesh.faceCount(), 3)};
  for (Index v = 0; v < mesh.vertexCount(); ++v) result.positions.row(v) = mesh.positions.row(from(v));
  for (Index i = 0; i < mesh.triangles.size(); ++i) result.triangles.data()[i] = moved(mesh.triangles.data()[i]);
  return result;
}

}  // namespace

VertexOrder::VertexOrder(std::vector<Index> order) : vertexAt_(std::move(order)), placeOf_(vertexAt_.size()) {
  for (std::size_t place = 0; place < vertexAt_.size(); ++place) placeOf_[vertexAt_[place]] = static_cast<Index>(place);
}

VertexOrder VertexOrder::of(const TriangleMesh& mesh) {
  const Graph graph = edgeGraph(mesh);
  return VertexOrder(eliminationTree(graph, eliminationOrder(graph, &mesh.positions)).order);
}

TriangleMesh VertexOrder::ordered(const TriangleMesh& mesh) const {
  if (isFileOrder()) return mesh;
  return renumbered(mesh, [&](Index v) { return placeOf_[v]; }, [&](Index place) { return vertexAt_[place]; });
}

TriangleMesh VertexOrder::inFileOrder(const TriangleMesh& mesh) const {
  if (isFileOrder()) return mesh;
  return renumbered(mesh, [&](Index place) { return vertexAt_[place]; }, [&](Index v) { return placeOf_[v]; });
}

Settings VertexOrder::ordered(const Settings& settings, const std::vector<ParameterInfo>& infos) const {
  Settings result = settings;
  if (isFileOrder()) return result;
  for (std::size_t p = 0; p < infos.size(); ++p) {
    const Scalars& values = settings.scalars[p];
    if (infos[p].kind == ParameterKind::scalars) result.scalars[p] = ordered(values, 1);
    if (infos[p].kind == ParameterKind::rotations) result.scalars[p] = ordered(values, 4);
  }
  for (Index& v : result.handles.vertices) v = placeOf_[v];
  return result;
}

Scalars VertexOrder::ordered(const Scalars& ofVertices, Index numbersEach) const {
  Scalars result(ofVertices.size());
  for (Index place = 0; place * numbersEach < ofVertices.size(); ++place) {
    result.segment(place * numbersEach, numbersEach) = ofVertices.segment(vertexAt_[place] * numbersEach, numbersEach);
  }
  return result;
}

}  // namespace whittle
