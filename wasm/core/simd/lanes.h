#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#if defined(__wasm_simd128__)
#include <wasm_simd128.h>
#elif defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace whittle {

/// Four lanes in single precision: what SSE, NEON and wasm SIMD have. Kernels are written in them because no compiler
/// finds these vectorizations by itself, and because the same operations in the same order give the same bits
/// everywhere.
typedef float Lanes __attribute__((vector_size(16)));
/// Four numbers in double precision, for what single precision would cancel away.
typedef double DoubleLanes __attribute__((vector_size(32)));
/// What comparing lanes gives: all bits of a lane or none.
typedef std::int32_t LaneMask __attribute__((vector_size(16)));

inline Lanes load(const void* p) {
  Lanes v;
  std::memcpy(&v, p, sizeof v);
  return v;
}

inline void store(void* p, Lanes v) { std::memcpy(p, &v, sizeof v); }

/// Sets one lane of what lies in memory there. An assignment to `v[lane]` takes all four out and puts them back.
inline void setLane(Lanes& v, int lane, float value) {
  std::memcpy(reinterpret_cast<char*>(&v) + lane * sizeof value, &value, sizeof value);
}

inline Lanes splat(float value) { return Lanes{value, value, value, value}; }

/// The number at p in every lane, in one instruction where there is one.
inline Lanes loadSplat(const float* p) {
#if defined(__wasm_simd128__)
  return (Lanes)wasm_v128_load32_splat(p);
#else
  return splat(*p);
#endif
}

/// A point or vector in single precision: xyz and a spare lane.
struct alignas(16) LaneRow {
  float x = 0, y = 0, z = 0, spare = 0;
};

/// One after the other, filled up to whole batches where elements are taken four at a time.
using LaneRows = std::vector<LaneRow>;

/// How many batches of four hold so many elements; the last one is filled up with elements that stand for nothing.
inline std::size_t batchCount(std::int32_t elements) { return (static_cast<std::size_t>(elements) + 3) / 4; }

inline Lanes toSingle(DoubleLanes v) { return __builtin_convertvector(v, Lanes); }
inline DoubleLanes toDouble(Lanes v) { return __builtin_convertvector(v, DoubleLanes); }

inline Lanes select(LaneMask mask, Lanes yes, Lanes no) {
  return (Lanes)(((LaneMask)yes & mask) | ((LaneMask)no & ~mask));
}

inline LaneMask select(LaneMask mask, LaneMask yes, LaneMask no) { return (yes & mask) | (no & ~mask); }

/// Zero where the mask is not set.
inline Lanes keep(LaneMask mask, Lanes v) { return (Lanes)((LaneMask)v & mask); }

/// The smaller and the larger of two; b where one is not a number.
#if defined(__wasm_simd128__)
inline Lanes minimum(Lanes a, Lanes b) { return (Lanes)wasm_f32x4_pmin((v128_t)b, (v128_t)a); }
inline Lanes maximum(Lanes a, Lanes b) { return (Lanes)wasm_f32x4_pmax((v128_t)b, (v128_t)a); }
#elif defined(__SSE2__)
inline Lanes minimum(Lanes a, Lanes b) { return (Lanes)_mm_min_ps((__m128)a, (__m128)b); }
inline Lanes maximum(Lanes a, Lanes b) { return (Lanes)_mm_max_ps((__m128)a, (__m128)b); }
#else
inline Lanes minimum(Lanes a, Lanes b) { return select(a < b, a, b); }
inline Lanes maximum(Lanes a, Lanes b) { return select(a > b, a, b); }
#endif

inline Lanes absolute(Lanes v) { return (Lanes)((LaneMask)v & INT32_MAX); }
/// The size of `size` (not negative) with the sign of `sign`.
inline Lanes withSign(Lanes size, Lanes sign) { return (Lanes)((LaneMask)size | ((LaneMask)sign & INT32_MIN)); }

inline Lanes squareRoot(Lanes v) {
#if defined(__wasm_simd128__)
  return (Lanes)wasm_f32x4_sqrt((v128_t)v);
#elif defined(__SSE2__)
  return (Lanes)_mm_sqrt_ps((__m128)v);
#else
  return Lanes{std::sqrt(v[0]), std::sqrt(v[1]), std::sqrt(v[2]), std::sqrt(v[3])};
#endif
}

inline bool any(LaneMask mask) {
#if defined(__wasm_simd128__)
  return wasm_v128_any_true((v128_t)mask);
#elif defined(__SSE2__)
  return _mm_movemask_ps((__m128)mask) != 0;
#else
  return (mask[0] | mask[1] | mask[2] | mask[3]) != 0;
#endif
}

inline bool all(LaneMask mask) { return !any(~mask); }

inline double sumOf(DoubleLanes v) { return (v[0] + v[1]) + (v[2] + v[3]); }

/// a0 b0 a1 b1 and a2 b2 a3 b3; a0 a1 b0 b1 and a2 a3 b2 b3. As shuffles that the compiler does not see through: it
/// would melt several into one that no machine has, and the browser then makes a dozen instructions of it.
#if defined(__wasm_simd128__)
inline Lanes interleaveLow(Lanes a, Lanes b) { return (Lanes)wasm_i32x4_shuffle((v128_t)a, (v128_t)b, 0, 4, 1, 5); }
inline Lanes interleaveHigh(Lanes a, Lanes b) { return (Lanes)wasm_i32x4_shuffle((v128_t)a, (v128_t)b, 2, 6, 3, 7); }
inline Lanes joinLow(Lanes a, Lanes b) { return (Lanes)wasm_i64x2_shuffle((v128_t)a, (v128_t)b, 0, 2); }
inline Lanes joinHigh(Lanes a, Lanes b) { return (Lanes)wasm_i64x2_shuffle((v128_t)a, (v128_t)b, 1, 3); }
#else
inline Lanes interleaveLow(Lanes a, Lanes b) { return Lanes{a[0], b[0], a[1], b[1]}; }
inline Lanes interleaveHigh(Lanes a, Lanes b) { return Lanes{a[2], b[2], a[3], b[3]}; }
inline Lanes joinLow(Lanes a, Lanes b) { return Lanes{a[0], a[1], b[0], b[1]}; }
inline Lanes joinHigh(Lanes a, Lanes b) { return Lanes{a[2], a[3], b[2], b[3]}; }
#endif

/// Rows become columns: of four vectors, the first lanes, the second lanes, …
inline void transpose(Lanes& a, Lanes& b, Lanes& c, Lanes& d) {
  const Lanes ab0 = interleaveLow(a, b), ab1 = interleaveHigh(a, b);
  const Lanes cd0 = interleaveLow(c, d), cd1 = interleaveHigh(c, d);
  a = joinLow(ab0, cd0);
  b = joinHigh(ab0, cd0);
  c = joinLow(ab1, cd1);
  d = joinHigh(ab1, cd1);
}

/// Sums of the lanes of four vectors.
inline Lanes horizontalSums(Lanes a, Lanes b, Lanes c, Lanes d) {
  transpose(a, b, c, d);
  return (a + b) + (c + d);
}

}  // namespace whittle
