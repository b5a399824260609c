#pragma once

#include <vector>

#include "base/sparse_matrix.h"
#include "mesh/adjacency.h"
#include "simd/lanes.h"

namespace whittle {

/// A place where two parts touch: a point of one part, a vertex or on an edge, and the point of a face of another that
/// is there. A u = Σ weight · vertex over both, the first with weights of sum 1, the second of sum −1.
struct Attachment {
  static constexpr int kMost = 5;
  Index vertices[kMost];
  double weights[kMost];  // 0 where fewer are needed; the vertex is then one of the others
};

/// Ties parts where they touch: the energy Σ κ |A δ|² over displacements δ, in which what touched at rest keeps its
/// distance, in direction too. Rotations do not see it: its offsets, shorter than `kContactReach`, do not turn with
/// them. It is zero where parts move together, and so at rest.
class Attachments {
 public:
  /// κ against the cotangent weights of L. Weaker ties let gaps open (a tenth: five times as wide), stronger ones
  /// begin to hold the style back. 10 against the 3 L of spokes and rims.
  static constexpr double kStiffness = 10.0 / 3;

  Attachments() = default;
  explicit Attachments(std::vector<Attachment> rows) : rows_(std::move(rows)) {}

  bool empty() const { return rows_.empty(); }

  /// The lower triangle of κ AᵀA, #V×#V, without the rows and columns of held vertices.
  SparseMatrix lower(Index vertexCount, const std::vector<Index>& held = {}) const;
  /// Adds −κ AᵀA δ to the residual (#V); returns κ Σ |A δ|². Allocates nothing.
  double addForces(const LaneRows& displacements, LaneRows& residual) const;
  /// The same in double precision.
  double addForces(const Points& displacements, Points& residual) const;
  /// The parts with those that are tied as one, numbered by first vertex.
  Components tied(const Components& parts) const;

 private:
  std::vector<Attachment> rows_;
};

}  // namespace whittle
