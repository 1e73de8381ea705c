// SPDX-License-Identifier: BSD-3-Clause
// Rows of the mass matrix times a field of the grid.
#include <algorithm>

#include "mpm/kernels/mass_stencil.hpp"
#include "mpm/kernels/variants/basis_of.hpp"

namespace assay::mpm::ASSAY_INSTRUCTIONS {

template <int Dim>
void multiply_rows(const StencilRows<Dim>& rows);

namespace {

constexpr std::size_t stride = GridField<ASSAY_DIMENSION>::stride;
constexpr std::size_t lanes = stride * rows_at_once<ASSAY_DIMENSION>;  ///< numbers of the nodes that fill a pack

/// Those of a node and what is beside it in its pack.
ASSAY_INLINE const double* around(const StencilRows<ASSAY_DIMENSION>& rows, std::size_t i, std::size_t k) {
  return rows.from + static_cast<std::ptrdiff_t>(stride) * (static_cast<std::ptrdiff_t>(i) + rows.offsets[k]);
}

/// One row of all.
template <std::size_t Packs>
ASSAY_INLINE void multiply_alike(const StencilRows<ASSAY_DIMENSION>& rows, std::size_t i, double* to) {
  Pack<lanes> sum[Packs] = {};
  for (std::size_t k = 0; k < rows.offsets.size(); ++k) {
    const double* from = around(rows, i, k);
    for (std::size_t p = 0; p < Packs; ++p) {
      Pack<lanes> x;
      load<lanes>(x, from + lanes * p);
      sum[p] += rows.values[k] * x;
    }
  }
  for (std::size_t p = 0; p < Packs; ++p) store<lanes>(to + lanes * p, sum[p]);
}

/// Number k of the rows of a pack, for each of its numbers.
template <int Dim>
ASSAY_INLINE auto of_rows(const double* values, std::size_t k) {
  if constexpr (rows_at_once<Dim> == 1) {
    return values[k];
  } else {
    Pack<GridField<Dim>::stride * rows_at_once<Dim>> twice;
    load_twice(twice, values + rows_at_once<Dim> * k);
    return twice;
  }
}

/// A row each.
template <int Dim>
ASSAY_INLINE void multiply_own(const StencilRows<Dim>& rows, std::size_t i, double* to) {
  const double* values = rows.row(i);
  Pack<lanes> sum{}, x;
  for (std::size_t k = 0; k < rows.offsets.size(); ++k) {
    load<lanes>(x, around(rows, i, k));
    sum += of_rows<Dim>(values, k) * x;
  }
  store<lanes>(to, sum);
}

}  // namespace

#if ASSAY_DIMENSION == 2

namespace {

/// Packs of four nodes whose sums stay in registers.
#ifdef __AVX__
constexpr std::size_t packs_at_once = 4;
#else
constexpr std::size_t packs_at_once = 2;
#endif

}  // namespace

template <>
void multiply_rows<2>(const StencilRows<2>& rows) {
  static_assert(rows_at_once<2> == 4);
  constexpr std::size_t many = rows_at_once<2> * packs_at_once;
  std::size_t i = rows.begin;
  for (; rows.alike && i + many <= rows.end; i += many) multiply_alike<packs_at_once>(rows, i, rows.to + 2 * i);
  while (i < rows.end) {
    const std::size_t group = i / rows_at_once<2> * rows_at_once<2>, next = std::min(rows.end, group + rows_at_once<2>);
    double of_group[2 * rows_at_once<2>];
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

namespace {

/// Nodes whose sums stay in registers.
#ifdef __AVX__
constexpr std::size_t nodes_at_once = 8;
#else
constexpr std::size_t nodes_at_once = 4;
#endif

}  // namespace

template <>
void multiply_rows<3>(const StencilRows<3>& rows) {
  static_assert(rows_at_once<3> == 1);
  std::size_t i = rows.begin;
  for (; rows.alike && i + nodes_at_once <= rows.end; i += nodes_at_once)
    multiply_alike<nodes_at_once>(rows, i, rows.to + lanes * i);
  for (; rows.alike && i < rows.end; ++i) multiply_alike<1>(rows, i, rows.to + lanes * i);
  for (; i < rows.end; ++i) multiply_own(rows, i, rows.to + lanes * i);
}

#endif

}  // namespace assay::mpm::ASSAY_INSTRUCTIONS
