#pragma once

#include <vector>

#include "linear/panel_solve.h"
#include "linear/supernodes.h"

namespace whittle {

/// The factor as the solves stream it: of each supernode [L11⁻¹; −L21 L11⁻¹], rounded once to single precision. That is
/// half the memory to stream, and products instead of chains of substitutions.
class PackedFactor {
 public:
  /// Claims the memory for a pattern.
  /// @param supernodes to be kept by the caller as long as this is used
  /// @param rowOf where the right-hand side of each unknown stands
  /// @param spare a row that nobody reads
  void shape(const Supernodes& supernodes, const std::vector<Index>& rowOf, Index spare);

  /// @param inverted [L11⁻¹; −L21 L11⁻¹] of supernode s, column-major
  void pack(Index s, const double* inverted);

  /// Solves L Y = B in place for three right-hand sides in each of some groups of rows, which follow each other at a
  /// stride. A panel meets all of them while the cache holds it. Of kept unknowns the rows become what is left of B.
  void forward(LaneRow* rows, Index groups = 1, std::ptrdiff_t stride = 0);
  /// Solves Lᵀ X = Y in the same way. Of kept unknowns the rows hold X already.
  void backward(LaneRow* rows, Index groups = 1, std::ptrdiff_t stride = 0);

 private:
  SolvePanel panel(Index s) const;

  const Supernodes* supernodes_ = nullptr;
  std::vector<Index> paddedRows_;         // where the right-hand sides of each supernode stand, padded to whole tiles
  std::vector<std::size_t> paddedStart_;  // #supernodes + 1: into `paddedRows_`
  std::vector<std::size_t> tileStart_;    // #supernodes + 1: into `tiles_`
  std::vector<TileColumn> tiles_;
  std::vector<LaneRow> scratch_;
};

}  // namespace whittle
