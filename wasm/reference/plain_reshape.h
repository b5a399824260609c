#pragma once

#include <array>
#include <vector>

#include "constraints/handles.h"
#include "constraints/straight_chains.h"
#include "geometry/feature_edges.h"
#include "mesh/triangle_mesh.h"
#include "reference/plain_least_squares.h"

namespace whittle {

/// What is to be reshaped, in its unit frame, with what is told of a surface by other means.
struct PlainReshapeProblem {
  TriangleMesh mesh;
  std::vector<FacePair> pairs;     // all pairs of faces on an edge
  std::vector<double> similarity;  // ω_f of each pair
  Scalars sphericity;              // Γ, #F
  Handles handles;
  VertexChains straight = {};
  int maxIterations = 100;
};

/// Slippage-preserving reshaping (2023) as one would write it down from the paper: vertices V for given transformations
/// τ, transformations for given vertices, each by a least squares problem that is assembled and factored anew in every
/// iteration, in double precision. Where the print does not say what works, it is read as the authors' results have it:
/// Eq. 20 with τ⁻¹, Eq. 24 with lengths. Without finalization and repetition.
class PlainReshape {
 public:
  enum Term { transform, normal, sphericity, scale, handles, straight, connect, similarity, regularizer };
  static constexpr int kTerms = 9;
  using Energies = std::array<double, kTerms>;

  explicit PlainReshape(PlainReshapeProblem problem);

  /// A vertex solve, the tests, and unless they end the run a transformation solve. Returns whether it goes on.
  bool iterate();
  const Points& positions() const { return V_; }
  Mat3 transformation(Index face) const { return tau_.middleRows<3>(3 * face).transpose(); }

  /// The energy that the tests saw last, term by term: of V_k, τ_{k−1} and ω_{k−1}, with the lengths of V_k.
  const Energies& energies() const { return energies_; }
  int iterations() const { return iterations_; }
  /// Whether both systems could be solved up to now.
  bool isDefinite() const { return isDefinite_; }

  /// The halves of an iteration, for the caller to time: what `iterate` calls.
  void solveVertices();
  bool judge();
  void solveTransformations();

  /// The systems of the last solves: the columns of τ of face f are the points 3f, 3f + 1 and 3f + 2.
  const PlainLeastSquares& vertexSystem() const { return vertexSystem_; }
  const PlainLeastSquares& transformationSystem() const { return transformationSystem_; }

 private:
  Vec3 edgeOf(const Points& positions, Index halfEdge) const;
  Mat3 cornerRotation(Index halfEdge) const;
  double lengthBetween(const Scalars& lengths, Index v, Index w) const;
  Scalars presentLengths() const;
  /// Calls visit(term, row) for each row of the problem in V, for lengths l of half edges, and of that in τ.
  template <typename Visit>
  void visitVertexRows(const Scalars& lengths, Visit visit) const;
  template <typename Visit>
  void visitHandlesAndChains(const Scalars& lengths, Visit visit) const;
  template <typename Visit>
  void visitTransformationRows(Visit visit) const;

  PlainReshapeProblem problem_;
  MeshEdges edges_;
  Points rest_;          // ē, 3#F×3
  Scalars restLengths_;  // l̄, 3#F
  Points normals_;       // n̄, #F×3
  double average_ = 0;   // L_avg

  Points V_, previous_, best_;
  Points tau_;             // 3#F×3: the columns of τ, face by face
  Scalars targetLengths_;  // l, 3#F
  Scalars stress_;         // ω, 3#F
  PlainLeastSquares vertexSystem_, transformationSystem_;
  Energies energies_{};
  double energyBefore_ = 0, bestEnergy_ = 0;
  int iterations_ = 0;
  bool isDefinite_ = true;
};

}  // namespace whittle
