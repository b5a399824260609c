#pragma once

#include "linear/sparse_cholesky.h"
#include "methods/plastic/rigid_modes.h"

namespace whittle {

/// K x = b for the stiffness of a shell, over the nodes that are free; of what floats, forces and displacements are those
/// without rigid motion.
class ShellSystem {
 public:
  using Rows = RigidModes::Rows;

  /// Finds the pattern; `analyzeNext` analyzes it, slice by slice.
  void shape(const Shell& shell, std::vector<Index> nodeOf);
  double analyzeNext() { return cholesky_.analyzeNext(); }

  /// Begins to factor the stiffness of a shell in its present shape.
  /// @param modes of that shape, kept by the caller as long as the factor is used
  void beginFactorize(const Shell& shell, const RigidModes& modes);
  Status factorizeNext(double& share);

  Index unknowns() const { return 3 * stiffness_.nodes(); }
  const std::vector<Index>& nodeOf() const { return stiffness_.nodeOf(); }

  /// An approximation of K⁻¹ b in place, by the factor in single precision: positive definite.
  void approximate(Rows& b);
  /// K⁻¹ B in double precision, in place (#unknowns×k, k ≤ 24).
  Status solve(Rows& B);

  /// Numbers of all vertices (#V×3) as those of the nodes, and back, with zero for what is held.
  void gather(const Points& ofVertices, Scalars& ofNodes) const;
  void scatter(const Scalars& ofNodes, Points& ofVertices) const;

 private:
  Stiffness stiffness_;
  Points coordinates_;  // of the nodes
  const RigidModes* modes_ = nullptr;
  SparseCholesky cholesky_;
  Rows solution_;
};

}  // namespace whittle
