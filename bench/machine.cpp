// SPDX-License-Identifier: BSD-3-Clause
#include "bench/machine.hpp"

#include <cmath>

#include "harness/numeric/vector_clones.h"
#include "mpm/data/crew.hpp"

namespace assay::bench {

namespace {

ASSAY_VECTOR_CLONES void triad_of(double* __restrict a, const double* __restrict b, const double* __restrict c,
                                  std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) a[i] = b[i] + 3 * c[i];
}

}  // namespace

void triad(double* a, const double* b, const double* c, std::size_t n, int threads) {
  const auto pieces = static_cast<std::size_t>(threads);
  mpm::share_out(threads, pieces, [&](std::size_t k) {
    const std::size_t begin = k * n / pieces, end = (k + 1) * n / pieces;
    triad_of(a + begin, b + begin, c + begin, end - begin);
  });
}

namespace {

/// Rounds of x <- next(x) on numbers that stay in registers.
template <class Next>
[[gnu::always_inline]] inline double sum_after(std::size_t rounds, const Next& next) {
  constexpr std::size_t lanes = operations_a_round / 2;
  double x[lanes];
  for (std::size_t l = 0; l < lanes; ++l) x[l] = static_cast<double>(l);
  for (std::size_t k = 0; k < rounds; ++k) {
    for (std::size_t l = 0; l < lanes; ++l) x[l] = next(x[l]);
  }
  double sum = 0;
  for (const double value : x) sum += value;
  return sum;
}

}  // namespace

ASSAY_VECTOR_CLONES double multiply_add(std::size_t rounds) {
  return sum_after(rounds, [](double x) { return 0.999 * x + 0.001; });
}

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
__attribute__((target_clones("avx512f", "fma", "default")))
#endif
double
fused_multiply_add(std::size_t rounds) {
  return sum_after(rounds, [](double x) { return std::fma(0.999, x, 0.001); });
}

}  // namespace assay::bench
