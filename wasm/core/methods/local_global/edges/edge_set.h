#pragma once

#include <memory>
#include <vector>

#include "geometry/cotangent.h"
#include "mesh/triangle_mesh.h"
#include "methods/local_global/edges/stiff_edges.h"
#include "simd/lane_algebra.h"

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

/// The energy Σ_k Σ_{e∈N(k)} c_e |s_k R_k d_e − u_e|² over rotations R_k (and scales s_k), rest edges d and output
/// edges u, four elements k at a time. Neither kind lists edges: with g = Σ ±c_e d_e at the corners of a face (they sum
/// to zero), everything is sums of g times output edges and of rotated g.
///
/// All is written in changes from the rest shape: the displacements δ = V − V₀ and the rotation changes T_k = s_k R_k −
/// I. What single precision rounds off is then a share of the change, and of nothing it is nothing: at rest energy and
/// residual are exactly zero. With s = 1 the energy is Σ_k Σ_e c_e |δu_e|² − Σ_k tr(T_k M_k), and the local step
/// maximises tr(R_k M_k), M_k = M⁰_k + M′_k for
/// - the covariance of the rest shape, M⁰_k = 2 Σ_{e∈N(k)} c_e d_e d_eᵀ,
/// - what the displacements add to it, M′_k = 2 Σ_{e∈N(k)} c_e d_e δu_eᵀ.
///
/// Displacements and residual are rows (#V, filled up to whole batches).
///
/// A set is made without edges; `collectNext` collects them, and all else is for a set that has them all.
///
/// Elements come in ranges, so that a caller can take a few through the whole of its step before the next ones: what
/// they need is then still in the nearest cache.
class EdgeSet {
 public:
  EdgeSet(Index elementCount, Index vertexCount)
      : elementCount_(elementCount), restCovariances_(batchCount(elementCount)), stiff_(vertexCount) {}
  virtual ~EdgeSet() = default;

  /// Collects the edges of the next elements, a slice of them a call (see linear/slices.h); returns the share that is
  /// done.
  double collectNext();

  /// Rotations: one per vertex or one per face.
  Index elementCount() const { return elementCount_; }
  ElementRange allElements() const { return {0, elementCount_}; }

  /// M⁰_k, zero for what fills up the last batch.
  const std::vector<SymmetricLanes>& restCovariances() const { return restCovariances_; }

  /// What `gatherCovariances` leaves out of −L δ and the energy, which counts each of them so often.
  const StiffEdges& stiffEdges() const { return stiff_; }
  virtual int visits() const = 0;

  /// M′_k for the elements of a range from `covariances[0]` on, zero for what fills up the last batch. Adds their part
  /// of −L δ, L the cotangent Laplacian, to the residual (#V) of the global step. Returns their part of Σ_k Σ_e c_e
  /// |δu_e|².
  virtual double gatherCovariances(const LaneRows& displacements, ElementRange range, MatrixLanes* covariances,
                                   LaneRows& residual) const = 0;

  /// Adds the part of the rotation changes of a range, Σ T_k g: with that of all elements the residual is b − L V,
  /// which is the energy's downhill gradient over twice the number of elements that see each face.
  /// @param rotationChanges T_k from the first of the range on
  virtual void addRotationChanges(const MatrixLanes* rotationChanges, ElementRange range, LaneRows& residual) const = 0;

 protected:
  /// Collects the edges of a range of elements, each once and in their order.
  virtual void collect(ElementRange range) = 0;
  /// Frees what only collecting needs.
  virtual void endCollecting() {}
  void addStiffEdge(Index a, Index b, double weight) { stiff_.add(a, b, weight); }
  void setRestCovariance(Index element, const Mat3& value) {
    setSymmetric(restCovariances_[element / 4], element % 4, value);
  }

 private:
  Index elementCount_;
  Index collected_ = 0;
  std::vector<SymmetricLanes> restCovariances_;
  StiffEdges stiff_;
};

/// A set without edges yet; the mesh and its cotangents must outlive the collecting.
std::unique_ptr<EdgeSet> makeEdgeSet(EdgeSetKind kind, const TriangleMesh& rest, const CornerScalars& halfCotangents);

/// The gradients g at the three corners of a face, one a column.
Mat3 cornerGradients(const TriangleMesh& rest, const CornerScalars& halfCotangents, Index face);

}  // namespace whittle
