// SPDX-License-Identifier: BSD-3-Clause
// A few numbers that one instruction works on where the processor has it: GCC's and clang's vectors. What the kernels
// are made of is always inlined, so that each set of instructions has its own and none leaks into another's.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

/// Of what kernels call.
#define ASSAY_INLINE [[gnu::always_inline]] inline

/// Before a loop: its rounds do not depend on each other.
#ifdef __clang__
#define ASSAY_INDEPENDENT
#else
#define ASSAY_INDEPENDENT _Pragma("GCC ivdep")
#endif
/// Before a loop of few rounds: what it works on is to stay in registers.
#ifdef __clang__
#define ASSAY_UNROLLED _Pragma("unroll")
#else
#define ASSAY_UNROLLED _Pragma("GCC unroll 8")
#endif

namespace assay::mpm {

/// Where the processor has no vector as long: two halves.
template <class Half>
struct Halves {
  Half low, high;

  static constexpr std::size_t half = sizeof(Half) / sizeof(double);
  ASSAY_INLINE double operator[](std::size_t k) const { return k < half ? low[k] : high[k - half]; }

  ASSAY_INLINE Halves& operator+=(const Halves& b) { return low += b.low, high += b.high, *this; }
  ASSAY_INLINE Halves& operator*=(double b) { return low *= b, high *= b, *this; }
  ASSAY_INLINE friend Halves operator+(const Halves& a, const Halves& b) { return {a.low + b.low, a.high + b.high}; }
  ASSAY_INLINE friend Halves operator-(const Halves& a, const Halves& b) { return {a.low - b.low, a.high - b.high}; }
  ASSAY_INLINE friend Halves operator*(const Halves& a, const Halves& b) { return {a.low * b.low, a.high * b.high}; }
  ASSAY_INLINE friend Halves operator*(double a, const Halves& b) { return {a * b.low, a * b.high}; }
  ASSAY_INLINE friend Halves operator*(const Halves& a, double b) { return b * a; }
  ASSAY_INLINE friend Halves operator+(const Halves& a, double b) { return {a.low + b, a.high + b}; }
  ASSAY_INLINE friend Halves operator+(double a, const Halves& b) { return b + a; }
  ASSAY_INLINE friend Halves operator-(const Halves& a, double b) { return {a.low - b, a.high - b}; }
  ASSAY_INLINE friend Halves operator-(double a, const Halves& b) { return {a - b.low, a - b.high}; }
};

template <int N>
struct PackOf;
template <>
struct PackOf<1> {
  using Doubles = double __attribute__((vector_size(8)));
};
template <>
struct PackOf<2> {
  using Doubles = double __attribute__((vector_size(16)));
};
template <>
struct PackOf<4> {
#ifdef __AVX__
  using Doubles = double __attribute__((vector_size(32)));
#else
  using Doubles = Halves<PackOf<2>::Doubles>;
#endif
};
template <>
struct PackOf<8> {
#ifdef __AVX512F__
  using Doubles = double __attribute__((vector_size(64)));
#else
  using Doubles = Halves<PackOf<4>::Doubles>;
#endif
};

/// N doubles, N = 1, 2, 4 or 8; + - * act on each, and with a single number on all.
template <int N>
using Pack = typename PackOf<N>::Doubles;

/// Room for n numbers in a pack.
constexpr int pack_size(int n) { return static_cast<int>(std::bit_ceil(static_cast<unsigned>(n))); }

template <int N>
ASSAY_INLINE void load(Pack<N>& pack, const double* from) {
  std::memcpy(&pack, from, sizeof pack);
}

template <int N>
ASSAY_INLINE void store(double* to, const Pack<N>& pack) {
  std::memcpy(to, &pack, sizeof pack);
}

/// to += pack
template <int N>
ASSAY_INLINE void add(double* to, const Pack<N>& pack) {
  Pack<N> sum;
  std::memcpy(&sum, to, sizeof sum);
  sum += pack;
  std::memcpy(to, &sum, sizeof sum);
}

/// Of all numbers.
template <int N>
ASSAY_INLINE double sum_of(const Pack<N>& pack) {
  double sums[N];
  store<N>(sums, pack);
  for (int width = N / 2; width > 0; width /= 2) {
    for (int k = 0; k < width; ++k) sums[k] += sums[k + width];
  }
  return sums[0];
}

/// Four numbers and four more, side by side; and apart again.
ASSAY_INLINE void join(Pack<8>& both, const Pack<4>& low, const Pack<4>& high) {
#ifdef __AVX512F__
  both = __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
#else
  both = {low, high};
#endif
}
ASSAY_INLINE void split(const Pack<8>& both, Pack<4>& low, Pack<4>& high) {
#ifdef __AVX512F__
  low = __builtin_shufflevector(both, both, 0, 1, 2, 3);
  high = __builtin_shufflevector(both, both, 4, 5, 6, 7);
#else
  low = both.low, high = both.high;
#endif
}

/// Four numbers, each twice.
ASSAY_INLINE void load_twice(Pack<8>& pack, const double* from) {
#ifdef __AVX512F__
  Pack<4> once;
  load<4>(once, from);
  pack = __builtin_shufflevector(once, once, 0, 0, 1, 1, 2, 2, 3, 3);
#else
  const double twice[8] = {from[0], from[0], from[1], from[1], from[2], from[2], from[3], from[3]};
  load<8>(pack, twice);
#endif
}

/// Each rounded towards zero, |x| < 2^31.
template <int N>
ASSAY_INLINE void truncate(const Pack<N>& x, std::array<std::int32_t, N>& whole, Pack<N>& rounded) {
  double values[N];
  store<N>(values, x);
  for (std::size_t k = 0; k < N; ++k) values[k] = whole[k] = static_cast<std::int32_t>(values[k]);
  load<N>(rounded, values);
}

/// The first n of a pack; the others zero.
template <int N>
ASSAY_INLINE void fill(Pack<N>& pack, const double* from, std::size_t n) {
  double values[N] = {};
  for (std::size_t k = 0; k < n; ++k) values[k] = from[k];
  std::memcpy(&pack, values, sizeof pack);
}

}  // namespace assay::mpm
