#pragma once

namespace whittle {

/// Long work goes slice by slice, so that whoever drives it can say in between how far it is, stop it, or turn to
/// something else. `…Next` does a slice of about the work (> 0) that it is given, but at least the smallest piece, and
/// tells the share of all that is done: below 1 until the end, and then exactly 1. Where the cuts are makes no
/// difference to the bits of a result, and doing it in one go is nothing but a loop over slices.
///
/// Work is counted in multiply-adds of dense panels, or in what takes as long: some 8 to the nanosecond on a fast
/// machine, where a slice takes 10 to 15 ms as wasm. Pieces that are not cut take up to 40 ms there for 160 000
/// unknowns.
constexpr double kSliceWork = 1e8;

}  // namespace whittle
