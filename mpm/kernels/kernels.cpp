// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/kernels/kernels.hpp"

#include "mpm/kernels/mass_stencil.hpp"
#include "mpm/setup/with_basis.hpp"

namespace assay::mpm {

#define ASSAY_DECLARE_KERNELS(SET)                                                      \
  namespace SET {                                                                       \
  template <class B, int Dim>                                                           \
  Kernels<Dim> table();                                                                 \
  template <int Dim>                                                                    \
  std::size_t advance(const Deformations<Dim>& deformations, std::size_t n, double dt); \
  template <int Dim>                                                                    \
  void multiply_rows(const StencilRows& rows);                                          \
  }

ASSAY_DECLARE_KERNELS(baseline)
ASSAY_DECLARE_KERNELS(v3)
ASSAY_DECLARE_KERNELS(v4)
#undef ASSAY_DECLARE_KERNELS

#if ASSAY_DIMENSION == 2

/// A name in the namespace of a set of instructions.
#ifdef ASSAY_DISPATCHES
#define ASSAY_OF(SET, ...) \
  ((SET) == Instructions::v4 ? v4::__VA_ARGS__ : (SET) == Instructions::v3 ? v3::__VA_ARGS__ : baseline::__VA_ARGS__)
#else
#define ASSAY_OF(SET, ...) (static_cast<void>(SET), baseline::__VA_ARGS__)
#endif

template <>
Kernels<2> kernels_of(Basis basis, Instructions instructions) {
  return with_basis<2>(basis, [&](auto tag) {
    using B = typename decltype(tag)::type;
    return ASSAY_OF(instructions, table<B, 2>());
  });
}

template <>
AdvanceDeformation<2> advance_deformation(Instructions instructions) {
  return ASSAY_OF(instructions, advance<2>);
}

template <>
MultiplyRows multiply_rows_of<2>(Instructions instructions) {
  return ASSAY_OF(instructions, multiply_rows<2>);
}

#else

template <>
Kernels<3> kernels_of(Basis basis, Instructions) {
  return with_basis<3>(basis, [&](auto tag) { return baseline::table<typename decltype(tag)::type, 3>(); });
}

template <>
AdvanceDeformation<3> advance_deformation(Instructions) {
  return baseline::advance<3>;
}

template <>
MultiplyRows multiply_rows_of<3>(Instructions) {
  return baseline::multiply_rows<3>;
}

#endif

}  // namespace assay::mpm
