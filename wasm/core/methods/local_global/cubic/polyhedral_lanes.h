#pragma once

#include "methods/local_global/cubic/cubic_lanes.h"
#include "methods/local_global/cubic/polyhedron.h"

namespace whittle {

/// A row of a polyhedron and a normal, of four vertices: the subgradient u ∈ [−1, 1] of |b · R n|, and where that is
/// held at its kink.
struct KinkLanes {
  Lanes u;
  LaneMask isActive;
};

/// A polyhedron's rows in single precision.
class PolyhedronRows {
 public:
  struct Row {
    float x, y, z, length;
  };

  explicit PolyhedronRows(const Polyhedron& polyhedron);

  std::size_t size() const { return count_; }
  const Row* begin() const { return rows_.data(); }
  const Row* end() const { return rows_.data() + count_; }
  /// Whether the rows are the axes, in order.
  bool areAxes() const { return areAxes_; }

  /// Σ_k κ_k Σ_j l_j |b_j · R n_k|
  Lanes regularizers(const CubicLanes& vertices, const QuaternionLanes& rotations) const;

 private:
  std::array<Row, Polyhedron::kMostRows> rows_;
  std::size_t count_;
  bool areAxes_;
};

/// max_R tr(R M) − Σ_k κ_k Σ_j l_j |b_j · R n_k| for four vertices with normals n_k, from rotations and subgradients
/// that are updated: Newton's method with an augmented Lagrangian for what is at its kink b_j · R n_k = 0, of which
/// there may be more than a rotation has degrees of freedom (the faces of a prism, the normals of a corner). Certified
/// as in `CubicExact`.
/// @param kinks of each row for the first normal, then for the second, …
/// @param open lanes that need no certificate
Climbed climbPolyhedral(const CubicLanes& vertices, const PolyhedronRows& rows, LaneMask open,
                        std::span<KinkLanes> kinks, QuaternionLanes& rotations);

}  // namespace whittle
