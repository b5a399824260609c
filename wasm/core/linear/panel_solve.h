#pragma once

#include "base/types.h"
#include "simd/lanes.h"

namespace whittle {

/// Four rows of a column.
struct alignas(16) TileColumn {
  float rows[4];
};

/// A panel P = [L11⁻¹; −L21 L11⁻¹] of a supernode in single precision, stored in tiles of four rows (each tile holds its
/// four rows of one column after the other), the last tile padded with zeros.
struct SolvePanel {
  const TileColumn* tiles;
  const Index*
      rows;  // where the right-hand sides stand, own ones first, padded to whole tiles with a row that nobody reads
  Index columns;
  Index height;

  Index tileCount() const { return (height + 3) / 4; }
  const TileColumn* tile(Index t) const { return tiles + static_cast<std::ptrdiff_t>(t) * columns; }
};

/// Writes a column-major panel in double precision as tiles. `tiles` holds `tileCount`×`columns` of them.
void packTiles(const double* panel, Index height, Index columns, TileColumn* tiles);

/// Forward step: own rows ← L11⁻¹ own; rows below −= L21 L11⁻¹ own. `scratch` holds `columns` rows.
void panelForward(const SolvePanel& panel, LaneRow* rhs, LaneRow* scratch);

/// Backward step: own rows ← Pᵀ [own; below]. `scratch` holds 3×`tileCount` rows, of which nothing is kept.
void panelBackward(const SolvePanel& panel, LaneRow* rhs, LaneRow* scratch);

}  // namespace whittle
