// SPDX-License-Identifier: BSD-3-Clause
// The inner loops of the passes, over a block of particles: compiled for each basis and for each set of instructions
// that a processor may have. The best one that this processor has is taken when a simulation is set up; the sets give
// the same bits.
#pragma once

#include <array>
#include <cstddef>

#include "mpm/data/blocks.hpp"
#include "mpm/data/instructions.hpp"
#include "mpm/kernels/kernel_state.hpp"
#include "mpm/kernels/mass_rows.hpp"
#include "mpm/setup/method.hpp"

namespace assay::mpm {

/// Returns the first particle with which something is wrong, or none_bad.
template <int Dim>
using BlockKernel = std::size_t (*)(KernelState<Dim>&, const Block&, const Instant&);

/// The particle's velocity after the step: the grid's, its own and what the grid gains, or a blend.
enum class Velocity { of_grid, kept, blended };

/// What particles carry of the velocity around them: its gradient, or its first moment.
enum class Around { nothing, gradient, moment };

/// By Velocity, whether L is wanted, whether the body force's power is.
template <int Dim>
using Gathers = std::array<std::array<std::array<BlockKernel<Dim>, 2>, 2>, 3>;

/// Of one basis.
template <int Dim>
struct Kernels {
  /// Weights; bad: a particle whose domain reaches outside the grid or is turned inside out.
  BlockKernel<Dim> place = nullptr;
  /// Mass and momentum to the grid; by Around.
  std::array<BlockKernel<Dim>, 3> momentum{};
  /// Internal force to the grid; [1]: and body force.
  std::array<BlockKernel<Dim>, 2> force{};
  /// Both at once.
  std::array<std::array<BlockKernel<Dim>, 2>, 3> momentum_and_force{};
  /// Positions and velocities from the grid, and corners that move one by one.
  Gathers<Dim> gather{};
  /// And what `fitted` does; null where no corners move.
  Gathers<Dim> gather_and_fit{};
  BlockKernel<Dim> velocity_gradient = nullptr;
  /// What carries the velocity around a particle: its first moment; the gradient; that convected; fitted and convected.
  BlockKernel<Dim> moment = nullptr, gradient = nullptr, convected = nullptr, fitted = nullptr;
  /// Of the initial velocity gradient to its first moment.
  BlockKernel<Dim> first_moment = nullptr;
  /// force += M x, x of Dim components a node in packs.
  void (*multiply_mass)(const KernelState<Dim>&, const Block&, const double* x) = nullptr;
  /// Rows of M += those of the block's particles; null of a basis that reaches different numbers of nodes.
  void (*add_mass_rows)(const KernelState<Dim>&, const Block&, const MassRows<Dim>&) = nullptr;
};

/// In three dimensions always the first set.
template <int Dim>
Kernels<Dim> kernels_of(Basis basis, Instructions instructions);
template <>
Kernels<2> kernels_of<2>(Basis basis, Instructions instructions);
template <>
Kernels<3> kernels_of<3>(Basis basis, Instructions instructions);

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
