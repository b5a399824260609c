#pragma once

#include <vector>

#include "linear/ordering.h"
#include "mesh/triangle_mesh.h"

namespace whittle {

/// The order in which the methods have the vertices: an elimination order, in which sparse factors stay sparse and what
/// the loops read together lies together. Faces stay as they were loaded.
class VertexOrder {
 public:
  /// The order in which the vertices were loaded.
  VertexOrder() = default;
  /// @param order place → vertex as loaded
  explicit VertexOrder(std::vector<Index> order);
  bool isAsLoaded() const { return vertexAt_.empty(); }
  /// The vertex, as loaded, at a place of this order.
  Index vertexAt(Index place) const { return isAsLoaded() ? place : vertexAt_[place]; }
  Index placeOf(Index vertex) const { return isAsLoaded() ? vertex : placeOf_[vertex]; }

  TriangleMesh ordered(const TriangleMesh& mesh) const;
  TriangleMesh asLoaded(const TriangleMesh& mesh) const;

  /// Rows of vertices as loaded (#V×n, or none) in this order.
  template <typename Rows>
  Rows orderedRows(const Rows& ofVertices) const {
    if (isAsLoaded()) return ofVertices;
    Rows result(ofVertices.rows(), ofVertices.cols());
    for (Index place = 0; place < ofVertices.rows(); ++place) result.row(place) = ofVertices.row(vertexAt_[place]);
    return result;
  }
  /// Rows in this order as loaded.
  template <typename Rows>
  Rows rowsAsLoaded(const Rows& ofPlaces) const {
    if (isAsLoaded()) return ofPlaces;
    Rows result(ofPlaces.rows(), ofPlaces.cols());
    for (Index place = 0; place < ofPlaces.rows(); ++place) result.row(vertexAt_[place]) = ofPlaces.row(place);
    return result;
  }

 private:
  std::vector<Index> vertexAt_;
  std::vector<Index> placeOf_;
};

/// The making of a good order for a mesh, the same everywhere.
class VertexOrdering {
 public:
  /// @param mesh to be kept by the caller until the order is there
  explicit VertexOrdering(const TriangleMesh& mesh);
  /// Its parts refer to each other.
  VertexOrdering(const VertexOrdering&) = delete;

  /// Does a slice of it (`linear/slices.h`); returns the share that is done.
  double next() { return order_.next(); }
  /// The order, once all is done.
  VertexOrder take();

 private:
  Graph graph_;
  EliminationOrdering order_;
};

}  // namespace whittle
