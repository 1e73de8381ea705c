// SPDX-License-Identifier: BSD-3-Clause
// What the machine can do at best, measured in the run that its figures are compared with.
#pragma once

#include <cstddef>

namespace assay::bench {

/// a = b + s c of n numbers each, on so many threads: 24 bytes a number go to and from memory (STREAM's triad).
void triad(double* a, const double* b, const double* c, std::size_t n, int threads);

/// Multiplications and additions, two operations each, in numbers that stay in registers. Returns their sum.
double multiply_add(std::size_t rounds);
/// The same, fused; slow where the processor cannot.
double fused_multiply_add(std::size_t rounds);
inline constexpr std::size_t operations_a_round = 2 * 96;

}  // namespace assay::bench
