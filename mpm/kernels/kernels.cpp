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
  void multiply_rows(const StencilRows<Dim>& rows);                                     \
  }

ASSAY_DECLARE_KERNELS(baseline)
ASSAY_DECLARE_KERNELS(v3)
ASSAY_DECLARE_KERNELS(v4)
#undef ASSAY_DECLARE_KERNELS

/// A name in the namespace of a set of instructions, of the sets that were compiled (cmake/instructions.cmake). In
/// three dimensions there is one set.
#if ASSAY_DIMENSION == 3
#define ASSAY_OF(SET, ...) baseline::__VA_ARGS__
#elif defined(ASSAY_KERNELS_BASELINE) && defined(ASSAY_KERNELS_V3)
#define ASSAY_OF(SET, ...) \
  ((SET) == Instructions::v4 ? v4::__VA_ARGS__ : (SET) == Instructions::v3 ? v3::__VA_ARGS__ : baseline::__VA_ARGS__)
#elif defined(ASSAY_KERNELS_V4)
#define ASSAY_OF(SET, ...) v4::__VA_ARGS__
#elif defined(ASSAY_KERNELS_V3)
#define ASSAY_OF(SET, ...) v3::__VA_ARGS__
#else
#define ASSAY_OF(SET, ...) baseline::__VA_ARGS__
#endif

template <>
Kernels<ASSAY_DIMENSION> kernels_of(Basis basis, [[maybe_unused]] Instructions instructions) {
  return with_basis<ASSAY_DIMENSION>(basis, [&](auto tag) {
    using B = typename decltype(tag)::type;
    return ASSAY_OF(instructions, table<B, ASSAY_DIMENSION>());
  });
}

template <>
AdvanceDeformation<ASSAY_DIMENSION> advance_deformation([[maybe_unused]] Instructions instructions) {
  return ASSAY_OF(instructions, advance<ASSAY_DIMENSION>);
}

template <>
MultiplyRows<ASSAY_DIMENSION> multiply_rows_of<ASSAY_DIMENSION>([[maybe_unused]] Instructions instructions) {
  return ASSAY_OF(instructions, multiply_rows<ASSAY_DIMENSION>);
}

}  // namespace assay::mpm
