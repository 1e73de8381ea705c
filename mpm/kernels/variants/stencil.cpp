// SPDX-License-Identifier: BSD-3-Clause
// Rows of the mass matrix times a field of the grid.
#include <algorithm>

#include "mpm/kernels/mass_stencil.hpp"
#include "mpm/kernels/variants/basis_of.hpp"

namespace assay::mpm::ASSAY_INSTRUCTIONS {

template <int Dim>
void multiply_rows(const StencilRows& rows);

#if ASSAY_DIMENSION == 2

namespace {

/// Packs of four nodes whose sums stay in registers.
#ifdef __AVX__
constexpr std::size_t packs_at_once = 4;
#else
constexpr std::size_t packs_at_once = 2;
#endif

/// One row of all.
template <std::size_t Packs>
ASSAY_INLINE void multiply_alike(const StencilRows& rows, std::size_t i, double* to) {
  Pack<8> sum[Packs] = {};
  for (std::size_t k = 0; k < rows.offsets.size(); ++k) {
    const double* from = rows.from + 2 * (static_cast<std::ptrdiff_t>(i) + rows.offsets[k]);
    for (std::size_t p = 0; p < Packs; ++p) {
      Pack<8> x;
      load<8>(x, from + 8 * p);
      sum[p] += rows.values[k] * x;
    }
  }
  for (std::size_t p = 0; p < Packs; ++p) store<8>(to + 8 * p, sum[p]);
}

/// A row each.
ASSAY_INLINE void multiply_own(const StencilRows& rows, std::size_t i, double* to) {
  const double* values = rows.row(i);
  Pack<8> sum{}, x, m;
  for (std::size_t k = 0; k < rows.offsets.size(); ++k) {
    load<8>(x, rows.from + 2 * (static_cast<std::ptrdiff_t>(i) + rows.offsets[k]));
    load_twice(m, values + rows_at_once * k);
    sum += m * x;
  }
  store<8>(to, sum);
}

}  // namespace

template <>
void multiply_rows<2>(const StencilRows& rows) {
  static_assert(rows_at_once == 4);
  constexpr std::size_t many = rows_at_once * packs_at_once;
  std::size_t i = rows.begin;
  for (; rows.alike && i + many <= rows.end; i += many) multiply_alike<packs_at_once>(rows, i, rows.to + 2 * i);
  while (i < rows.end) {
    const std::size_t group = i / rows_at_once * rows_at_once, next = std::min(rows.end, group + rows_at_once);
    double of_group[2 * rows_at_once];
    if (rows.alike) {
      multiply_alike<1>(rows, group, of_group);
    } else {
      multiply_own(rows, group, of_group);
    }
    std::copy_n(of_group + 2 * (i - group), 2 * (next - i), rows.to + 2 * i);
    i = next;
  }
}

#else

template <>
void multiply_rows<3>(const StencilRows& rows) {
  constexpr std::size_t S = GridField<3>::stride;
  const std::size_t entries = rows.offsets.size();
  for (std::size_t i = rows.begin; i < rows.end; ++i) {
    double sum[3] = {};
    const double* own = rows.alike ? nullptr : rows.row(i);
    for (std::size_t k = 0; k < entries; ++k) {
      const auto at = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) + rows.offsets[k]);
      const double m = rows.alike ? rows.values[k] : own[k * rows_at_once];
      for (std::size_t d = 0; d < 3; ++d) sum[d] += m * rows.from[S * at + d];
    }
    std::copy_n(sum, 3, rows.to + S * i);
  }
}

#endif

}  // namespace assay::mpm::ASSAY_INSTRUCTIONS
