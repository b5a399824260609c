#include "geometry/cut_mesh.h"

#include <numeric>

#include "mesh/disjoint_sets.h"

namespace whittle {

namespace {

Index vertexAt(const Triangles& triangles, Index corner) { return triangles.data()[corner]; }
Index tailOf(Index halfEdge) { return halfEdge; }
Index headOf(Index halfEdge) { return 3 * faceOf(halfEdge) + headCorner(halfEdge); }

/// Whether both faces of an edge go on as one surface.
bool isSeam(const Triangles& triangles, const MeshEdges& edges, const std::vector<bool>& cuts, Index edge) {
  if (edges.faceCountAt(edge) != 2 || cuts[edge]) return false;
  const Index first = edges.halfEdges[edges.start[edge]], second = edges.halfEdges[edges.start[edge] + 1];
  return vertexAt(triangles, tailOf(first)) != vertexAt(triangles, tailOf(second));
}

}  // namespace

CutMesh::CutMesh(const Triangles& mesh, const MeshEdges& edges, const std::vector<bool>& cuts)
    : triangles(mesh.rows(), 3) {
  DisjointSets corners(static_cast<Index>(mesh.size()));
  std::vector<Index> links;  // half edges, one for each edge of the cut mesh
  links.reserve(edges.count());
  for (Index e = 0; e < edges.count(); ++e) {
    const Index* halfEdges = edges.halfEdges.data() + edges.start[e];
    if (isSeam(mesh, edges, cuts, e)) {
      corners.join(tailOf(halfEdges[0]), headOf(halfEdges[1]));
      corners.join(headOf(halfEdges[0]), tailOf(halfEdges[1]));
      links.push_back(halfEdges[0]);
    } else {
      links.insert(links.end(), halfEdges, halfEdges + edges.faceCountAt(e));
    }
  }
  for (Index corner = 0; corner < mesh.size(); ++corner) {
    const Index first = corners.find(corner);
    if (first == corner) {
      triangles.data()[corner] = count();
      vertex.push_back(vertexAt(mesh, corner));
    } else {
      triangles.data()[corner] = triangles.data()[first];
    }
  }
  start.assign(count() + 2, 0);
  for (const Index h : links) {
    ++start[triangles.data()[tailOf(h)] + 2];
    ++start[triangles.data()[headOf(h)] + 2];
  }
  std::partial_sum(start.begin(), start.end(), start.begin());
  neighbours.resize(start.back());
  for (const Index h : links) {
    const Index tail = triangles.data()[tailOf(h)], head = triangles.data()[headOf(h)];
    neighbours[start[tail + 1]++] = head;
    neighbours[start[head + 1]++] = tail;
  }
  start.pop_back();
}

}  // namespace whittle
