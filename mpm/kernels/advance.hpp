// SPDX-License-Identifier: BSD-3-Clause
// The deformation gradient of a block of particles over a step.
#pragma once

#include <array>
#include <cstddef>

#include "mpm/data/instructions.hpp"

namespace assay::mpm {

/// Components of n particles each; row-major, Dim x Dim.
template <int Dim>
struct Deformations {
  std::array<double*, Dim * Dim> F{};              ///< before the step; after it
  std::array<const double*, Dim * Dim> rate{};     ///< L, or dF/dt
  std::array<double*, Dim * Dim> before{}, now{};  ///< copies of F at both ends
  bool rate_of_F = false;                          ///< what rate holds
};

/// F <- (I + dt L) F, or F + dt dF/dt. The first particle with det F <= 0 or no number, or n.
template <int Dim>
using AdvanceDeformation = std::size_t (*)(const Deformations<Dim>&, std::size_t n, double dt);

template <int Dim>
AdvanceDeformation<Dim> advance_deformation(Instructions instructions);
template <>
AdvanceDeformation<2> advance_deformation<2>(Instructions instructions);
template <>
AdvanceDeformation<3> advance_deformation<3>(Instructions instructions);

}  // namespace assay::mpm
