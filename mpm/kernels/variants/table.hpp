// SPDX-License-Identifier: BSD-3-Clause
// The kernels of one basis.
#pragma once

#include "mpm/kernels/variants/to_grid.hpp"
#include "mpm/kernels/variants/to_particles.hpp"

namespace assay::mpm::ASSAY_INSTRUCTIONS {

template <class B, Velocity Kind, bool Fits, int Dim>
constexpr std::array<std::array<BlockKernel<Dim>, 2>, 2> gathers() {
  return {{{gather<B, Kind, false, false, Fits, Dim>, gather<B, Kind, false, true, Fits, Dim>},
           {gather<B, Kind, true, false, Fits, Dim>, gather<B, Kind, true, true, Fits, Dim>}}};
}

template <class B, bool Fits, int Dim>
constexpr Gathers<Dim> all_gathers() {
  return {gathers<B, Velocity::of_grid, Fits, Dim>(), gathers<B, Velocity::kept, Fits, Dim>(),
          gathers<B, Velocity::blended, Fits, Dim>()};
}

template <class B, Around Kind, int Dim>
constexpr std::array<BlockKernel<Dim>, 2> both() {
  return {momentum_and_force<B, Kind, false, Dim>, momentum_and_force<B, Kind, true, Dim>};
}

template <class B, int Dim>
Kernels<Dim> table() {
  Kernels<Dim> k;
  k.place = place<B, Dim>;
  k.momentum = {momentum<B, Around::nothing, Dim>, momentum<B, Around::gradient, Dim>,
                momentum<B, Around::moment, Dim>};
  k.momentum_and_force = {both<B, Around::nothing, Dim>(), both<B, Around::gradient, Dim>(),
                          both<B, Around::moment, Dim>()};
  k.gather = all_gathers<B, false, Dim>();
  if constexpr (B::traits.moves_corners) k.gather_and_fit = all_gathers<B, true, Dim>();
  k.force = {force<B, false, Dim>, force<B, true, Dim>};
  k.velocity_gradient = velocity_gradient<B, Dim>;
  k.multiply_mass = multiply_mass<B, Dim>;
  if constexpr (B::nodes_across > 0) k.add_mass_rows = add_mass_rows<B, Dim>;
  k.moment = carry<B, Carried::moment, Dim>;
  k.gradient = carry<B, Carried::gradient, Dim>;
  k.convected = carry<B, Carried::convected, Dim>;
  k.fitted = carry_fitted<B, Dim>;
  k.first_moment = first_moment<B, Dim>;
  return k;
}

}  // namespace assay::mpm::ASSAY_INSTRUCTIONS
