#pragma once

#include <vector>

#include "simd/lane_algebra.h"

namespace whittle {

/// Edges of thin faces. Their weights c are so large, and c δu cancels so much around a face, that single precision
/// would lose what the rest of the mesh says. All of theirs is done in double precision, on displacements of their own
/// for the vertices that they meet in. Few meshes have many.
class StiffEdges {
 public:
  /// Whether an edge of this weight belongs here. (Those of an equilateral face weigh 0.29 a side.)
  static bool isStiff(double weight) { return weight > 16 || weight < -16; }

  explicit StiffEdges(Index vertexCount) : placeOf_(vertexCount, -1) {}

  /// Takes an edge of energy c |δ_a − δ_b|². To be called before anything else.
  void add(Index a, Index b, double weight);

  /// Vertices that have displacements in double precision, by their place there.
  const std::vector<Index>& vertices() const { return vertices_; }

  /// Adds −L δ of these edges to the residual (#V); returns their energy.
  /// @param exact displacements of `vertices()`
  double addForces(const Points& exact, LaneRows& residual) const;

 private:
  struct Spoke {
    Index to;  // place
    double weight;
  };

  Index place(Index vertex);

  std::vector<Index> placeOf_;  // #V, or −1
  std::vector<Index> vertices_;
  std::vector<std::vector<Spoke>> rings_;  // of `vertices_`: each edge at both of its ends
};

}  // namespace whittle
