#include "linear/panel_solve.h"

#include <algorithm>

#include "base/lanes.h"

namespace whittle {

namespace {

/// Puts the products of a tile where they belong: rows of the supernode itself are replaced, those below gain.
void scatterTile(Lanes x, Lanes y, Lanes z, const SolvePanel& panel, Index tile, LaneRow* rhs) {
  Lanes spare = splat(0);
  transpose(x, y, z, spare);
  const Lanes products[] = {x, y, z, spare};
  for (int lane = 0; lane < 4; ++lane) {
    const Index place = 4 * tile + lane;
    LaneRow* row = rhs + panel.rows[place];
    store(row, place < panel.columns ? products[lane] : load(row) + products[lane]);
  }
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

/// Σ over the rows of one column times the gathered rows.
LaneRow columnProduct(const SolvePanel& panel, Index column, const LaneRow* lanes) {
  Lanes x = splat(0), y = splat(0), z = splat(0);
  for (Index tile = 0; tile < panel.tileCount(); ++tile) {
    const Lanes p = load(panel.tiles + 4 * (static_cast<std::ptrdiff_t>(tile) * panel.columns + column));
    x += p * load(lanes + 3 * tile);
    y += p * load(lanes + 3 * tile + 1);
    z += p * load(lanes + 3 * tile + 2);
  }
  LaneRow row;
  store(&row, horizontalSums(x, y, z, splat(0)));
  return row;
}

}  // namespace

void packTiles(const double* panel, Index height, Index columns, float* tiles) {
  for (Index tile = 0; tile * 4 < height; ++tile) {
    for (Index j = 0; j < columns; ++j) {
      for (Index lane = 0; lane < 4; ++lane) {
        const Index row = 4 * tile + lane;
        *tiles++ = row < height ? static_cast<float>(panel[row + static_cast<std::ptrdiff_t>(j) * height]) : 0.0f;
      }
    }
  }
}

void panelForward(const SolvePanel& panel, LaneRow* rhs, LaneRow* scratch) {
  const Index columns = panel.columns, tileCount = panel.tileCount();
  std::copy_n(rhs + panel.rows[0], columns, scratch);
  const std::ptrdiff_t tileSize = 4 * static_cast<std::ptrdiff_t>(columns);
  const float* tiles = panel.tiles;
  Index tile = 0;
  for (; tile + 1 < tileCount; tile += 2, tiles += 2 * tileSize) {  // two tiles share each splat
    Lanes x0 = splat(0), y0 = x0, z0 = x0, x1 = x0, y1 = x0, z1 = x0;
    for (Index j = 0; j < columns; ++j) {
      const Lanes p0 = load(tiles + 4 * j), p1 = load(tiles + tileSize + 4 * j);
      const Lanes x = splat(scratch[j].x), y = splat(scratch[j].y), z = splat(scratch[j].z);
      x0 += p0 * x, y0 += p0 * y, z0 += p0 * z;
      x1 += p1 * x, y1 += p1 * y, z1 += p1 * z;
    }
    scatterTile(x0, y0, z0, panel, tile, rhs);
    scatterTile(x1, y1, z1, panel, tile + 1, rhs);
  }
  if (tile < tileCount) {
    Lanes x = splat(0), y = x, z = x;
    for (Index j = 0; j < columns; ++j) {
      const Lanes p = load(tiles + 4 * j);
      x += p * splat(scratch[j].x), y += p * splat(scratch[j].y), z += p * splat(scratch[j].z);
    }
    scatterTile(x, y, z, panel, tile, rhs);
  }
}

void panelBackward(const SolvePanel& panel, LaneRow* rhs, LaneRow* scratch) {
  gatherTiles(panel, rhs, scratch);
  const Index columns = panel.columns, tileCount = panel.tileCount();
  LaneRow* own = rhs + panel.rows[0];
  Index j = 0;
  for (; j + 3 < columns; j += 4) {  // four columns share each gathered row
    Lanes x0 = splat(0), x1 = x0, x2 = x0, x3 = x0, y0 = x0, y1 = x0, y2 = x0, y3 = x0, z0 = x0, z1 = x0, z2 = x0, z3 = x0;
    const float* tiles = panel.tiles + 4 * j;
    const LaneRow* lanes = scratch;
    for (Index tile = 0; tile < tileCount; ++tile, tiles += 4 * static_cast<std::ptrdiff_t>(columns), lanes += 3) {
      const Lanes x = load(lanes), y = load(lanes + 1), z = load(lanes + 2);
      Lanes p = load(tiles);
      x0 += p * x, y0 += p * y, z0 += p * z;
      p = load(tiles + 4);
      x1 += p * x, y1 += p * y, z1 += p * z;
      p = load(tiles + 8);
      x2 += p * x, y2 += p * y, z2 += p * z;
      p = load(tiles + 12);
      x3 += p * x, y3 += p * y, z3 += p * z;
    }
    Lanes x = horizontalSums(x0, x1, x2, x3), y = horizontalSums(y0, y1, y2, y3), z = horizontalSums(z0, z1, z2, z3);
    Lanes spare = splat(0);
    transpose(x, y, z, spare);
    store(own + j, x), store(own + j + 1, y), store(own + j + 2, z), store(own + j + 3, spare);
  }
  for (; j < columns; ++j) own[j] = columnProduct(panel, j, scratch);
}

}  // namespace whittle
