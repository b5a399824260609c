#include "methods/vertex_order.h"

#include "linear/elimination_tree.h"
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

/// Triangles whose vertices have moved to other places.
template <typename Moved>
Triangles renumbered(Triangles triangles, const Moved& moved) {
  for (Index corner = 0; corner < triangles.size(); ++corner)
    triangles.data()[corner] = moved(triangles.data()[corner]);
  return triangles;
}

}  // namespace

VertexOrder::VertexOrder(std::vector<Index> order) : vertexAt_(std::move(order)), placeOf_(vertexAt_.size()) {
  for (std::size_t place = 0; place < vertexAt_.size(); ++place) placeOf_[vertexAt_[place]] = static_cast<Index>(place);
}

TriangleMesh VertexOrder::ordered(const TriangleMesh& mesh) const {
  return {orderedRows(mesh.positions), renumbered(mesh.triangles, [&](Index v) { return placeOf(v); })};
}

TriangleMesh VertexOrder::asLoaded(const TriangleMesh& mesh) const {
  return {rowsAsLoaded(mesh.positions), renumbered(mesh.triangles, [&](Index place) { return vertexAt(place); })};
}

VertexOrdering::VertexOrdering(const TriangleMesh& mesh) : graph_(edgeGraph(mesh)), order_(graph_, &mesh.positions) {}

VertexOrder VertexOrdering::take() { return VertexOrder(eliminationTree(graph_, order_.take()).order); }

}  // namespace whittle
