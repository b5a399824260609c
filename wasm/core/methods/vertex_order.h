#pragma once

#include <vector>

#include "mesh/triangle_mesh.h"
#include "methods/parameters.h"

namespace whittle {

/// The order in which the methods have the vertices: an elimination order, in which sparse factors stay sparse and what the loops read
/// together lies together. Faces stay as the file has them.
class VertexOrder {
 public:
  /// The file's own.
  VertexOrder() = default;
  /// @param order place → vertex of the file
  explicit VertexOrder(std::vector<Index> order);
  /// A good one for a mesh, the same everywhere.
  static VertexOrder of(const TriangleMesh& mesh);

  bool isFileOrder() const { return vertexAt_.empty(); }
  /// Vertex of the file.
  Index vertexAt(Index place) const { return isFileOrder() ? place : vertexAt_[place]; }

  TriangleMesh ordered(const TriangleMesh& mesh) const;
  TriangleMesh inFileOrder(const TriangleMesh& mesh) const;
  /// What belongs to vertices in a method's settings.
  Settings ordered(const Settings& settings, const std::vector<ParameterInfo>& infos) const;

 private:
  Scalars ordered(const Scalars& ofVertices, Index numbersEach) const;

  std::vector<Index> vertexAt_;
  std::vector<Index> placeOf_;
};

}  // namespace whittle
