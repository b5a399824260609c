#pragma once

#include <memory>
#include <vector>

#include "geometry/cotangent.h"
#include "geometry/lane_algebra.h"
#include "mesh/triangle_mesh.h"

namespace whittle {

/// Which edges each rotation sees (as-rigid-as-possible energies differ in nothing else).
enum class EdgeSetKind {
  spokesAndRims,  // a rotation per vertex, the edges of all its faces (Chao et al. 2010)
  faces,          // a rotation per face, its three edges
};

/// Elements from `first`, a multiple of 4, to before `end`.
struct ElementRange {
  Index first, end;

  std::size_t firstBatch() const { return static_cast<std::size_t>(first) / 4; }
  std::size_t endBatch() const { return batchCount(end); }
};

/// The energy Σ_k Σ_{e∈N(k)} c_e |R_k d_e − u_e|² over rotations R_k, rest edges d and output edges u, four elements k at a time.
/// Neither kind lists edges: with g = Σ ±c_e d_e at the corners of a face (they sum to zero), everything is sums of g times
/// output edges and of rotated g.
///
/// Elements come in ranges, so that a caller can take a few through the whole of its step before the next ones: what they need is
/// then still in the nearest cache.
class EdgeSet {
 public:
  virtual ~EdgeSet() = default;

  /// Rotations: one per vertex or one per face.
  virtual Index elementCount() const = 0;
  ElementRange allElements() const { return {0, elementCount()}; }

  /// Σ_k Σ_e c_e |d_e|², rounded like the covariances: the energy of the rest shape is zero.
  virtual double restEnergy() const = 0;

  /// M_k = 2 Σ_{e∈N(k)} c_e d_e u_eᵀ for the elements of a range (the local step maximises tr(R_k M_k)), from `covariances[0]` on, zero
  /// for what fills up the last batch. Adds their part of −L (V − V₀), L the cotangent Laplacian, to the residual (#V) of the global
  /// step. Returns their part of Σ_k Σ_e c_e |u_e|².
  virtual double gatherCovariances(const Points& output, ElementRange range, CovarianceLanes* covariances,
                                   std::vector<LaneRow>& residual) const = 0;

  /// Adds the part of the turns, Σ (s_k R_k − I) g over a range: with that of all elements the residual is b − L V, which is the energy's
  /// downhill gradient over twice the number of elements that see each face. Written in changes it is exactly zero at rest.
  /// @param rotations, growths of all elements; s_k − 1 where the energy lets its elements grow, Σ c_e |s_k R_k d_e − u_e|², empty
  ///   where all s_k are 1
  virtual void addSimilar(const std::vector<QuaternionLanes>& rotations, const std::vector<Lanes>& growths, ElementRange range,
                          std::vector<LaneRow>& residual) const = 0;
  /// The same without scales.
  void addRotated(const std::vector<QuaternionLanes>& rotations, ElementRange range, std::vector<LaneRow>& residual) const {
    addSimilar(rotations, {}, range, residual);
  }
};

/// s R − I of one batch.
inline MatrixLanes turnAt(const std::vector<QuaternionLanes>& rotations, const std::vector<Lanes>& growths, std::size_t batch) {
  return growths.empty() ? turnOf(rotations[batch]) : turnOf(rotations[batch], growths[batch]);
}

std::unique_ptr<EdgeSet> makeEdgeSet(EdgeSetKind kind, const TriangleMesh& rest, const CornerScalars& halfCotangents);

/// The gradients g at the three corners of a face, one a column.
Mat3 cornerGradients(const TriangleMesh& rest, const CornerScalars& halfCotangents, Index face);

}  // namespace whittle
