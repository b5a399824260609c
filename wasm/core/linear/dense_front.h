#pragma once

#include "base/types.h"

namespace whittle {

/// Products are made in square tiles; those at an edge read so many numbers more than there are, and use none of them.
/// Whoever claims memory for a panel or a scratch claims that much more.
constexpr Index kFrontPadding = 3;

/// C −= A Bᵀ for column-major C (rows×columns), A (rows×depth) and B (columns×depth), with their leading dimensions. A
/// and B are padded, C is not touched outside. Where `lowerOnly`, entries above the diagonal of C are unspecified
/// afterwards.
void subtractProduct(double* C, Index ldC, const double* A, Index ldA, const double* B, Index ldB, Index rows,
                     Index columns, Index depth, bool lowerOnly);

/// Columns that are factored or inverted at a time, so that a block of the panel stays in the first cache.
constexpr Index kFrontBlock = 24;

/// Cholesky-factors a block of columns, `first` to `first` + `kFrontBlock`, of the first `columns` columns of a symmetric
/// front, and takes it off the columns to its right. Block after block, a column-major panel of `rows`×`columns` (lower
/// part) becomes [L11; L21]. Returns false if a pivot is not positive; the panel is then unspecified. The panel is padded.
bool factorPanelBlock(double* panel, Index rows, Index columns, Index first);

/// Begins to make [L11⁻¹; −L21 L11⁻¹] of [L11; L21] (a factored panel, `factor`), with which both triangular solves
/// become plain products: `inverse` is a second panel of the same size. All panels are padded.
void beginInverse(const double* factor, double* inverse, Index rows, Index columns);

/// Finishes the block of columns of the inverse that ends before column `end`: `columns` first, then down by
/// `kFrontBlock`. `scratch` holds `columns`×`columns` numbers, padded.
void invertPanelBlock(const double* factor, double* inverse, double* scratch, Index rows, Index columns, Index end);

}  // namespace whittle
