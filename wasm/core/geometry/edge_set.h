#pragma once

#include <vector>

#include "geometry/cotangent.h"
#include "mesh/triangle_mesh.h"

namespace whittle {

/// Which edges each rotation sees (as-rigid-as-possible energies differ in nothing else).
enum class EdgeSetKind {
  spokesAndRims,  // a rotation per vertex, the edges of all its faces (Chao et al. 2010)
  faces,          // a rotation per face, its three edges
};

/// The energy Σ_k Σ_{e∈N(k)} c_e |R_k d_e − u_e|² over rotations R_k, rest edges d and output edges u. Both kinds are kept
/// in face form: per face the corner gradients g_k = Σ ±c_e d_e (they sum to zero), so every face is visited once and
/// the global step is a Poisson solve with the face's mean rotation.
class EdgeSet {
 public:
  /// `rest` is referred to, not copied: it must outlive the edge set.
  EdgeSet(EdgeSetKind kind, const TriangleMesh& rest);

  EdgeSetKind kind() const { return kind_; }
  /// Rotations: one per vertex or one per face.
  Index elementCount() const { return kind_ == EdgeSetKind::faces ? rest_.faceCount() : rest_.vertexCount(); }
  const CornerScalars& halfCotangents() const { return halfCotangents_; }

  /// M_k = 2 Σ_{e∈N(k)} c_e d_e u_eᵀ for every element (the local step maximises tr(R_k M_k)). `covariances` has
  /// `elementCount()` matrices. Returns Σ_k Σ_e c_e (|d_e|² + |u_e|²), the part of the energy that no rotation changes.
  double gatherCovariances(const Points& output, std::vector<Mat3>& covariances) const;

  /// The residual b − L V (#V×3) of the global step L V = b at the positions `output`; L is the cotangent Laplacian for both
  /// kinds. It is the energy's downhill gradient over twice the number of elements that see each face.
  void scatterResidual(const std::vector<Mat3>& rotations, const Points& output, Points& residual) const;

 private:
  Mat3 meanRotation(const std::vector<Mat3>& rotations, Index face) const;

  EdgeSetKind kind_;
  const TriangleMesh& rest_;
  CornerScalars halfCotangents_;   // #F×3, c_fe
  Points secondGradient_;          // #F×3, g of corner 1
  Points thirdGradient_;           // #F×3, g of corner 2; corner 0 has what makes the sum zero
  double restEnergy_ = 0;          // Σ_k Σ_e c_e |d_e|²
};

}  // namespace whittle
