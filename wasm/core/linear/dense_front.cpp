#include "linear/dense_front.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/tiering.h"

namespace whittle {

namespace {

/// Two lanes: what both SSE2 and wasm SIMD have.
typedef double Lanes __attribute__((vector_size(16)));

constexpr Index kTile = kFrontPadding + 1;  // rows and columns of a register tile: 8 accumulators
constexpr Index kDepth = 96;                // columns that a deep product takes at a time

Lanes load(const double* p) {
  Lanes v;
  std::memcpy(&v, p, sizeof v);
  return v;
}

/// A 4×4 tile of A Bᵀ, a column in each pair of lanes.
struct Tile {
  Lanes low[kTile] = {}, high[kTile] = {};

  Tile(const double* A, Index ldA, const double* B, Index ldB, Index depth) {
    for (Index l = 0; l < depth; ++l, A += ldA, B += ldB) {
      const Lanes a = load(A), b = load(A + 2);
      for (int j = 0; j < kTile; ++j) {
        const Lanes factor{B[j], B[j]};
        low[j] += a * factor, high[j] += b * factor;
      }
    }
  }
};

void subtractTile(double* C, Index ldC, const Tile& tile) {
  for (int j = 0; j < kTile; ++j, C += ldC) {
    const Lanes column[] = {load(C) - tile.low[j], load(C + 2) - tile.high[j]};
    std::memcpy(C, column, sizeof column);
  }
}

/// Subtracts of a tile at the edge only what lies inside.
void subtractPart(double* C, Index ldC, const Tile& tile, Index rows, Index columns) {
  for (Index j = 0; j < columns; ++j, C += ldC) {
    const double column[] = {tile.low[j][0], tile.low[j][1], tile.high[j][0], tile.high[j][1]};
    for (Index i = 0; i < rows; ++i) C[i] -= column[i];
  }
}

void subtract(double* C, Index ldC, const Tile& tile, Index rows, Index columns) {
  if (rows == kTile && columns == kTile) {
    subtractTile(C, ldC, tile);
  } else {
    subtractPart(C, ldC, tile, rows, columns);
  }
}

/// C −= A Bᵀ for A with zeros above row `begin` + l of each column l, which are skipped. Made for deep products:
/// columns of A lie far apart, so they come a few at a time, and rows of those meet all columns of C while they are in
/// the first cache.
void subtractDeepProduct(double* C, Index ldC, const double* A, Index ldA, Index begin, const double* B, Index ldB,
                         Index rows, Index columns, Index depth) {
  for (Index from = 0; from < depth; from += kDepth) {
    const double *a = A + from * static_cast<std::ptrdiff_t>(ldA), *b = B + from * static_cast<std::ptrdiff_t>(ldB);
    const Index first = begin + from, chunk = std::min(kDepth, depth - from);
    for (Index i = first - first % kTile; i < rows; i += kTile) {
      const Index height = std::min(kTile, rows - i), reach = std::min(chunk, i + kTile - first);
      for (Index j = 0; j < columns; j += kTile) {
        const Tile tile(a + i, ldA, b + j, ldB, reach);
        subtract(C + i + static_cast<std::ptrdiff_t>(j) * ldC, ldC, tile, height, std::min(kTile, columns - j));
      }
    }
  }
}

/// y −= X f for `count` contiguous columns of X, four at a time so that y is not written after each.
WHITTLE_OWN_FUNCTION void subtractColumns(double* __restrict y, const double* __restrict X, Index ld, const double* f,
                                          Index stride, Index count, Index rows) {
  Index l = 0;
  for (; l + 3 < count;
       l += 4, X += 4 * static_cast<std::ptrdiff_t>(ld), f += 4 * static_cast<std::ptrdiff_t>(stride)) {
    const double f0 = f[0], f1 = f[stride], f2 = f[2 * stride], f3 = f[3 * stride];
    const double *x0 = X, *x1 = X + ld, *x2 = X + 2 * ld, *x3 = X + 3 * ld;
    for (Index i = 0; i < rows; ++i) y[i] -= (f0 * x0[i] + f1 * x1[i]) + (f2 * x2[i] + f3 * x3[i]);
  }
  for (; l < count; ++l, X += ld, f += stride) {
    const double factor = *f;
    for (Index i = 0; i < rows; ++i) y[i] -= factor * X[i];
  }
}

/// Unblocked Cholesky of `columns` columns over all `rows`, column by column along contiguous rows.
bool factorBlock(double* panel, Index ld, Index rows, Index columns) {
  for (Index j = 0; j < columns; ++j) {
    double* pivot = panel + j + static_cast<std::ptrdiff_t>(j) * ld;
    subtractColumns(pivot, panel + j, ld, panel + j, ld, j, rows - j);
    if (!(*pivot > 0) || !std::isfinite(*pivot)) return false;
    const double inverse = 1 / std::sqrt(*pivot);
    for (Index i = 0; i < rows - j; ++i) pivot[i] *= inverse;
  }
  return true;
}

}  // namespace

void subtractProduct(double* C, Index ldC, const double* A, Index ldA, const double* B, Index ldB, Index rows,
                     Index columns, Index depth, bool lowerOnly) {
  for (Index j = 0; j < columns; j += kTile) {
    const Index width = std::min(kTile, columns - j);
    for (Index i = lowerOnly ? j : 0; i < rows; i += kTile) {
      const Index height = std::min(kTile, rows - i);
      subtract(C + i + static_cast<std::ptrdiff_t>(j) * ldC, ldC, Tile(A + i, ldA, B + j, ldB, depth), height, width);
    }
  }
}

bool factorPanelBlock(double* panel, Index rows, Index columns, Index first) {
  const Index width = std::min(kFrontBlock, columns - first);
  double* block = panel + first + static_cast<std::ptrdiff_t>(first) * rows;
  if (!factorBlock(block, rows, rows - first, width)) return false;
  const Index rest = columns - first - width;
  if (rest > 0) {
    double* remaining = block + width + static_cast<std::ptrdiff_t>(width) * rows;
    subtractProduct(remaining, rows, block + width, rows, block + width, rows, rows - first - width, rest, width, true);
  }
  return true;
}

void beginInverse(const double* factor, double* inverse, Index rows, Index columns) {
  // [I; −L21], which is multiplied by L11⁻¹ block by block of columns from the right.
  for (Index j = 0; j < columns; ++j) {
    double* column = inverse + static_cast<std::ptrdiff_t>(j) * rows;
    const double* L = factor + static_cast<std::ptrdiff_t>(j) * rows;
    std::fill_n(column, columns, 0.0);
    column[j] = 1;
    for (Index i = columns; i < rows; ++i) column[i] = -L[i];
  }
}

void invertPanelBlock(const double* factor, double* inverse, double* scratch, Index rows, Index columns, Index end) {
  const Index first = std::max<Index>(0, end - kFrontBlock), width = end - first, later = columns - end;
  double* block = inverse + static_cast<std::ptrdiff_t>(first) * rows;
  for (Index l = 0; l < later; ++l) {
    const double* row = factor + end + l + static_cast<std::ptrdiff_t>(first) * rows;
    for (Index j = 0; j < width; ++j) scratch[j + l * width] = row[static_cast<std::ptrdiff_t>(j) * rows];
  }
  const double* solved = inverse + static_cast<std::ptrdiff_t>(end) * rows;
  // A column that is solved already begins at its own row.
  subtractDeepProduct(block + first, rows, solved + first, rows, width, scratch, width, rows - first, width, later);
  for (Index j = width - 1; j >= 0; --j) {
    double* column = block + static_cast<std::ptrdiff_t>(j) * rows;
    const double* L = factor + static_cast<std::ptrdiff_t>(first + j) * rows + first;
    const Index below = first + j + 1;  // where the columns to the right begin
    subtractColumns(column + below, column + rows + below, rows, L + j + 1, 1, width - j - 1, rows - below);
    const double inversePivot = 1 / L[j];
    for (Index i = first + j; i < rows; ++i) column[i] *= inversePivot;
  }
}

}  // namespace whittle
