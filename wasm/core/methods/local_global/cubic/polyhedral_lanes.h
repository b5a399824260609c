#pragma once

#include "methods/local_global/cubic/polyhedron.h"
#include "simd/lane_algebra.h"

namespace whittle {

/// Subgradients u_j ∈ [−1, 1] of |b_j · R n| for each row of a polyhedron, of four vertices.
using SubgradientLanes = std::array<Lanes, Polyhedron::kMostRows>;

struct PolyhedralClimb {
  Lanes regularizers;  // κ Σ l_j |b_j · R n|
  LaneMask certified;
};

/// max_R tr(R M) − κ Σ_j l_j |b_j · R n| for four vertices, from rotations and subgradients that are updated: Newton's
/// method with an augmented Lagrangian for the rows at their kink b_j · R n = 0, of which there may be more than a
/// normal has degrees of freedom (the faces of a prism). Certified as in `CubicExact`.
PolyhedralClimb climbPolyhedral(const MatrixLanes& M, const VectorLanes& n, Lanes weights, const Polyhedron& polyhedron,
                                SubgradientLanes& subgradients, QuaternionLanes& rotations);

}  // namespace whittle
