#pragma once

#include <Eigen/SparseCholesky>
#include <optional>
#include <vector>

#include "base/sparse_matrix.h"
#include "constraints/gauge.h"
#include "constraints/handles.h"
#include "geometry/smooth_fans.h"
#include "mesh/triangle_mesh.h"
#include "reference/plain_rotation.h"

namespace whittle {

struct PlainProblem {
  double cubeness = 0;   // λ of cubic stylization; 0 is as-rigid-as-possible
  Handles handles = {};  // in the frame of the mesh
  AdmmConstants admm = {};
  double strength =
      0;  // λ of an analogy with constant targets: for each normal of the rest shape the closest of `style`
  Points style = Points(0, 3);  // unit normals
};

/// Cubic stylization, analogies and ARAP with spokes and rims as one would write them down from the papers: double
/// precision, a singular value decomposition per vertex and fit, Eigen's Cholesky factorization, plain alternation. One
/// thing is not in the papers: a vertex on a sharp edge has a normal for each smooth fan of its faces.
/// Every phase is a call of its own, for the caller to time. Meshes come in the unit frame.
class PlainLocalGlobal {
 public:
  /// `rest` must outlive this.
  PlainLocalGlobal(const TriangleMesh& rest, PlainProblem problem) : rest_(rest), problem_(std::move(problem)) {}

  /// The phases of preparing, in this order. `factorize` returns whether the system was positive definite.
  void assemble();
  void analyze();
  bool factorize();
  bool prepare();

  using Cholesky = Eigen::SimplicialLLT<SparseMatrix, Eigen::Lower, Eigen::AMDOrdering<Index>>;

  /// The system without its held rows and columns, #free×#free, and its factorization.
  const SparseMatrix& freeBlock() const { return freeBlock_; }
  const Cholesky& cholesky() const { return cholesky_; }

  /// Puts the handles in their places and forgets earlier iterations.
  void begin(Points& positions);

  /// The phases of an iteration, in this order.
  void localStep(const Points& positions);
  void rightHandSide();
  void solve(Points& positions);
  void iterate(Points& positions);

  /// Σ_i [ Σ_{e∈N(i)} c_e |R_i d_e − u_e|² + Σ_k λ a_k |R_i n_k|₁ ], or + λ A_k |R_i n_k − t_k|², over the smooth fans k
  /// of each vertex, with the rotations of the last local step.
  double energy(const Points& positions) const;

 private:
  /// An edge as seen from one face of a vertex.
  struct HalfEdge {
    Index from, to;
    double c;  // half the cotangent of the angle opposite to it in that face
    Vec3 d;    // rest vector
  };

  void listHalfEdges();
  void lookUpTargets();
  void assembleSystem();
  void splitSystem();

  const TriangleMesh& rest_;
  PlainProblem problem_;

  // What the rest shape says
  Scalars areas_;                    // #V, barycentric
  SmoothFans fans_;                  // of each vertex; on a smooth surface it has one
  Scalars fanAreas_;                 // #fans, barycentric
  Points normals_;                   // #fans×3
  Scalars targetWeights_;            // #fans, λ A with mixed Voronoi areas; empty without a style
  Points targets_;                   // #fans×3, t
  std::vector<Index> start_;         // #V + 1, into halfEdges_
  std::vector<HalfEdge> halfEdges_;  // the edges of all faces of vertex 0, of vertex 1, …
  Eigen::SparseMatrix<double, Eigen::RowMajor, Index> rightHandSideOf_;  // K, #V×3#V: B = K [R_0ᵀ; R_1ᵀ; …]

  // What the rest shape and the handles say; the system is three times the cotangent Laplacian
  std::optional<Gauge> gauge_;
  std::vector<Index> free_, held_;  // vertices
  SparseMatrix system_;             // #V×#V
  SparseMatrix freeBlock_;          // #free×#free
  SparseMatrix heldBlock_;          // #free×#held
  Cholesky cholesky_;

  // Running state
  Points rotations_;  // 3#V×3: R_0ᵀ, R_1ᵀ, …
  Points rightHandSide_;
  std::vector<AdmmState> admm_;  // #fans
};

/// Longest move of a vertex as a share of the largest displacement: the papers' stopping rule (2019, §3.1).
double relativeDisplacement(const Points& before, const Points& after, const Points& rest);

/// The mesh in its unit frame.
TriangleMesh inUnitFrame(TriangleMesh mesh);

}  // namespace whittle
