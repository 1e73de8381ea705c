// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/kernels.hpp"

#include "mpm/advance.hpp"
#include "mpm/mass_stencil.hpp"
#include "mpm/with_basis.hpp"

namespace assay::mpm {

namespace baseline {
template <class B, int Dim>
Kernels<Dim> table();
template <int Dim>
std::size_t advance(const Deformations<Dim>& deformations, std::size_t n, double dt);
template <int Dim>
void add_products(const StencilLine& line);
}  // namespace baseline
namespace v3 {
template <class B, int Dim>
Kernels<Dim> table();
template <int Dim>
std::size_t advance(const Deformations<Dim>& deformations, std::size_t n, double dt);
template <int Dim>
void add_products(const StencilLine& line);
}  // namespace v3
namespace v4 {
template <class B, int Dim>
Kernels<Dim> table();
template <int Dim>
std::size_t advance(const Deformations<Dim>& deformations, std::size_t n, double dt);
template <int Dim>
void add_products(const StencilLine& line);
}  // namespace v4

template <>
Kernels<2> kernels_of(Basis basis, Instructions instructions) {
  return with_basis<2>(basis, [&](auto tag) {
    using B = typename decltype(tag)::type;
#ifdef ASSAY_DISPATCHES
    if (instructions == Instructions::v4) return v4::table<B, 2>();
    if (instructions == Instructions::v3) return v3::table<B, 2>();
#endif
    (void)instructions;
    return baseline::table<B, 2>();
  });
}

template <>
Kernels<3> kernels_of(Basis basis, Instructions) {
  return with_basis<3>(basis, [&](auto tag) { return baseline::table<typename decltype(tag)::type, 3>(); });
}

template <>
AdvanceDeformation<2> advance_deformation(Instructions instructions) {
#ifdef ASSAY_DISPATCHES
  if (instructions == Instructions::v4) return v4::advance<2>;
  if (instructions == Instructions::v3) return v3::advance<2>;
#endif
  (void)instructions;
  return baseline::advance<2>;
}

template <>
AdvanceDeformation<3> advance_deformation(Instructions) {
  return baseline::advance<3>;
}

template <>
AddProducts add_products_of<2>(Instructions instructions) {
#ifdef ASSAY_DISPATCHES
  if (instructions == Instructions::v4) return v4::add_products<2>;
  if (instructions == Instructions::v3) return v3::add_products<2>;
#endif
  (void)instructions;
  return baseline::add_products<2>;
}

template <>
AddProducts add_products_of<3>(Instructions) {
  return baseline::add_products<3>;
}

}  // namespace assay::mpm
