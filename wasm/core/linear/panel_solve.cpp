#include "linear/panel_solve.h"

#include <algorithm>

#include "simd/lanes.h"

namespace whittle {

namespace {

/// Puts the products of a tile where they belong: rows of the supernode itself are replaced, those below gain.
void scatterTile(Lanes x, Lanes y, Lanes z, const SolvePanel& panel, Index tile, LaneRow* rhs) {
  Lanes spare = splat(0);
  transpose(x, y, z, spare);
  const Lanes products[] = {x, y, z, spare};
  const Index* rows = panel.rows + 4 * tile;
  const Index own = panel.columns - 4 * tile;
  for (int lane = 0; lane < 4; ++lane) {
    LaneRow* row = rhs + rows[lane];
    store(row, lane < own ? products[lane] : load(row) + products[lane]);
  }
}

/// Forward products of some tiles, which share each splat of a right-hand side.
template <int kTiles>
void forwardTiles(const SolvePanel& panel, Index first, const LaneRow* own, LaneRow* rhs) {
  const TileColumn* tiles = panel.tile(first);
  const Index columns = std::min(panel.columns, 4 * (first + kTiles));  // L11⁻¹ is lower triangular
  Lanes x[kTiles] = {}, y[kTiles] = {}, z[kTiles] = {};
  for (Index j = 0; j < columns; ++j, ++tiles) {
    const Lanes ownX = loadSplat(&own[j].x), ownY = loadSplat(&own[j].y), ownZ = loadSplat(&own[j].z);
    for (int t = 0; t < kTiles; ++t) {
      const Lanes p = load(tiles + t * static_cast<std::ptrdiff_t>(panel.columns));
      x[t] += p * ownX, y[t] += p * ownY, z[t] += p * ownZ;
    }
  }
  for (int t = 0; t < kTiles; ++t) scatterTile(x[t], y[t], z[t], panel, first + t, rhs);
}

/// The lanes x, y, z of the rows of every tile.
void gatherTiles(const SolvePanel& panel, const LaneRow* rhs, LaneRow* lanes) {
  for (Index tile = 0; tile < panel.tileCount(); ++tile) {
    const Index* rows = panel.rows + 4 * tile;
    Lanes x = load(rhs + rows[0]), y = load(rhs + rows[1]), z = load(rhs + rows[2]), spare = load(rhs + rows[3]);
    transpose(x, y, z, spare);
    store(lanes + 3 * tile, x);
    store(lanes + 3 * tile + 1, y);
    store(lanes + 3 * tile + 2, z);
  }
}

/// Backward products of some columns, which share each gathered row.
template <int kColumns>
void backwardColumns(const SolvePanel& panel, Index first, const LaneRow* lanes, LaneRow* rhs) {
  const Index top = first / 4;  // L11⁻¹ is lower triangular
  const TileColumn* tiles = panel.tile(top) + first;
  lanes += 3 * top;
  Lanes x[4] = {}, y[4] = {}, z[4] = {};
  for (Index tile = top; tile < panel.tileCount(); ++tile, tiles += panel.columns, lanes += 3) {
    const Lanes rowX = load(lanes), rowY = load(lanes + 1), rowZ = load(lanes + 2);
    for (int j = 0; j < kColumns; ++j) {
      const Lanes p = load(tiles + j);
      x[j] += p * rowX, y[j] += p * rowY, z[j] += p * rowZ;
    }
  }
  Lanes sums[] = {horizontalSums(x[0], x[1], x[2], x[3]), horizontalSums(y[0], y[1], y[2], y[3]),
                  horizontalSums(z[0], z[1], z[2], z[3]), splat(0)};
  transpose(sums[0], sums[1], sums[2], sums[3]);
  for (int j = 0; j < kColumns; ++j) store(rhs + panel.rows[first + j], sums[j]);
}

}  // namespace

void packTiles(const double* panel, Index height, Index columns, TileColumn* tiles) {
  const Index wholeTiles = height / 4, rest = height % 4;
  for (Index tile = 0; tile < wholeTiles; ++tile) {
    const double* column = panel + 4 * tile;
    for (Index j = 0; j < columns; ++j, ++tiles, column += height) {
      DoubleLanes rows;
      std::memcpy(&rows, column, sizeof rows);
      store(tiles, toSingle(rows));
    }
  }
  if (rest == 0) return;
  const double* column = panel + 4 * wholeTiles;
  for (Index j = 0; j < columns; ++j, ++tiles, column += height) {
    for (Index lane = 0; lane < 4; ++lane) tiles->rows[lane] = lane < rest ? static_cast<float>(column[lane]) : 0.0f;
  }
}

void panelForward(const SolvePanel& panel, LaneRow* rhs, LaneRow* scratch) {
  for (Index j = 0; j < panel.columns; ++j) scratch[j] = rhs[panel.rows[j]];
  const Index tileCount = panel.tileCount();
  // Two at a time: of a third the sums no longer fit into the registers that a browser has.
  Index tile = 0;
  for (; tile + 1 < tileCount; tile += 2) forwardTiles<2>(panel, tile, scratch, rhs);
  if (tile < tileCount) forwardTiles<1>(panel, tile, scratch, rhs);
}

void panelBackward(const SolvePanel& panel, LaneRow* rhs, LaneRow* scratch) {
  gatherTiles(panel, rhs, scratch);
  Index j = 0;
  for (; j + 1 < panel.columns; j += 2) backwardColumns<2>(panel, j, scratch, rhs);
  if (j < panel.columns) backwardColumns<1>(panel, j, scratch, rhs);
}

}  // namespace whittle
