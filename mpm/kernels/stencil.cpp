// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/kernels/basis_of.hpp"
#include "mpm/mass_stencil.hpp"

namespace assay::mpm::ASSAY_INSTRUCTIONS {

template <int Dim>
void add_products(const StencilLine& line);

template <>
void add_products<2>(const StencilLine& line) {
  const double *m = line.m, *from = line.from;
  double* to = line.to;
  ASSAY_INDEPENDENT
  for (std::size_t i = 0; i < line.nodes; ++i) {
    to[2 * i] += m[i] * from[2 * i];
    to[2 * i + 1] += m[i] * from[2 * i + 1];
  }
}

#ifndef ASSAY_ONLY_2D
template <>
void add_products<3>(const StencilLine& line) {
  constexpr std::size_t S = GridField<3>::stride;
  for (std::size_t i = 0; i < line.nodes; ++i) {
    for (std::size_t d = 0; d < 3; ++d) line.to[S * i + d] += line.m[i] * line.from[S * i + d];
  }
}
#endif

}  // namespace assay::mpm::ASSAY_INSTRUCTIONS
