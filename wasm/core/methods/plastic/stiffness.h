#pragma once

#include "linear/symmetric_blocks.h"
#include "methods/plastic/shell.h"

namespace whittle {

/// The Hessian of a shell's energy in the vertices that are free to move, made positive: what the curvature of the second
/// form itself would add is left out, and of the membrane stress what presses together (clamped, in 2×2). In a shell at
/// rest neither is there, and the matrix is the exact Hessian.
class Stiffness {
 public:
  Stiffness() = default;
  /// Finds the pattern.
  /// @param nodeOf #V, rising from 0 over the free vertices, −1 for those that are held
  Stiffness(const Shell& shell, std::vector<Index> nodeOf);

  Index nodes() const { return blocks_.nodes(); }
  const std::vector<Index>& nodeOf() const { return nodeOf_; }

  /// Sets the values to those of the shell in its present shape.
  void assemble(const Shell& shell);
  /// Adds to the block of a node.
  void add(Index node, const Mat3& block) { blocks_.add(blocks_.place(node, node), block); }

  /// #3 nodes×#3 nodes, the lower triangle.
  const SparseMatrix& matrix() const { return blocks_.matrix(); }

 private:
  /// What couples a face's corners and those across its sides: −1 where a side is a border or a vertex is held.
  struct Stencil {
    std::array<Index, 6> nodes;
    std::array<Index, 21> places;  // of the pairs (a, c ≤ a)
  };

  std::vector<Index> nodeOf_;
  std::vector<Stencil> stencils_;
  SymmetricBlocks blocks_;
};

/// The part of a symmetric matrix without its negative eigenvalues.
Mat2 positivePart(const Mat2& a);

}  // namespace whittle
