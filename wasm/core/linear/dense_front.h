#pragma once

#include "base/types.h"

namespace whittle {

/// Products are made in square tiles; those at an edge read so many numbers more than there are, and use none of them. Whoever
/// claims memory for a panel or a scratch claims that much more.
constexpr Index kFrontPadding = 3;

/// C −= A Bᵀ for column-major C (rows×columns), A (rows×depth) and B (columns×depth), with their leading dimensions.
/// A and B are padded, C is not touched outside. Where `lowerOnly`, entries above the diagonal of C are unspecified afterwards.
void subtractProduct(double* C, Index ldC, const double* A, Index ldA, const double* B, Index ldB, Index rows, Index columns,
                     Index depth, bool lowerOnly);

/// Cholesky-factors the first `columns` columns of a symmetric front, given as a column-major panel of `rows`×`columns`
/// (lower part), into [L11; L21]. Returns false if a pivot is not positive; the panel is then unspecified. The panel is
/// padded.
bool factorPanel(double* panel, Index rows, Index columns);

/// From [L11; L21] (a factored panel, `factor`) to [L11⁻¹; −L21 L11⁻¹], with which both triangular solves become plain
/// products: `inverse` is a second panel of the same size. `scratch` holds `columns`×`columns` numbers. All three are padded.
void invertPanel(const double* factor, double* inverse, double* scratch, Index rows, Index columns);

}  // namespace whittle
