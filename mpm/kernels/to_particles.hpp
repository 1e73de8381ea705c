// SPDX-License-Identifier: BSD-3-Clause
// From the grid to particles: positions, velocities, gradients, corners, the velocity around a particle.
#pragma once

#include "mpm/affine.hpp"
#include "mpm/corners.hpp"
#include "mpm/kernels/basis_of.hpp"

namespace assay::mpm::ASSAY_INSTRUCTIONS {

/// Grid motion at a few particles: velocity and acceleration, and the slopes of the velocity.
template <bool Gradient, int Dim>
using MotionOfParticles = Taken<2 * Dim, Gradient ? Dim : 0, Dim>;

/// Positions, velocities, L. Whether all positions and velocities are numbers.
template <Velocity Kind, bool Gradient, int Dim>
ASSAY_INLINE bool move(KernelState<Dim>& s, std::size_t begin, std::size_t n,
                       const MotionOfParticles<Gradient, Dim>& motion, const Instant& now) {
  const double flip = s.method.flip, dt = now.dt, kick = now.kick;
  int lost = 0;
  for (std::size_t d = 0; d < Dim; ++d) {
    double *x = s.column(Column::position, static_cast<int>(d)) + begin,
           *v = s.column(Column::velocity, static_cast<int>(d)) + begin;
    ASSAY_INDEPENDENT
    for (std::size_t k = 0; k < n; ++k) {
      const double of_grid = motion.value[d][k];
      x[k] += dt * of_grid;
      if constexpr (Kind == Velocity::of_grid) {
        v[k] = of_grid;
      } else {
        const double kept = v[k] + kick * motion.value[Dim + d][k];
        v[k] = Kind == Velocity::kept ? kept : flip * kept + (1 - flip) * of_grid;
      }
    }
    for (std::size_t k = 0; k < n; ++k) lost |= 0 * (x[k] + v[k]) != 0 ? 1 : 0;
    if constexpr (Gradient) {
      for (std::size_t i = 0; i < Dim; ++i) {
        double* L = s.column(Column::velocity_gradient, static_cast<int>(i * Dim + d)) + begin;
        ASSAY_INDEPENDENT
        for (std::size_t k = 0; k < n; ++k) L[k] = motion.slope[d][i][k];
      }
    }
  }
  return lost == 0;
}

/// The first of n particles whose position or velocity is no number.
template <int Dim>
std::size_t first_lost(const KernelState<Dim>& s, std::size_t begin, std::size_t n) {
  for (std::size_t p = begin; p < begin + n; ++p) {
    double finite = 0;
    for (int d = 0; d < Dim; ++d) finite += 0 * (s.column(Column::position, d)[p] + s.column(Column::velocity, d)[p]);
    if (!(finite == 0)) return p;
  }
  return none_bad;
}

/// Power: sum of m b . v of the block, v the grid's velocity at the particle. (The FLIP particle's own velocity is
/// another one: with it the energy account would not close however short the step.)
template <class B, Velocity Kind, bool Gradient, bool Power, int Dim>
std::size_t gather(KernelState<Dim>& s, const Block& block, const Instant& now) {
  const B& basis = basis_of<B>(s);
  MotionOfParticles<Gradient, Dim> motion;
  double power = 0;
  std::size_t bad = none_bad;
  for_chunks(basis, block, [&](std::size_t begin, std::size_t n, auto& nodes) {
    basis.sum_all(nodes, n, s.motion.data(), motion);
    if constexpr (Power) {
      const double *mass = s.column(Column::mass) + begin, *b = s.column(Column::body_force) + begin;
      for (std::size_t k = 0; k < n; ++k) {
        for (std::size_t d = 0; d < Dim; ++d) power += mass[k] * b[d * s.particles + k] * motion.value[d][k];
      }
    }
    if (!move<Kind, Gradient>(s, begin, n, motion, now) && bad == none_bad) bad = first_lost(s, begin, n);
  });
  if constexpr (Power) s.block_power[block.begin / block_size] = power;
  return bad;
}

/// L = sum_i v_i (x) grad phi_ip of the grid velocity.
template <class B, int Dim>
ASSAY_INLINE Mat<Dim> gradient_at(const KernelState<Dim>& s, const B& basis, const typename B::Nodes& nodes,
                                  std::size_t k) {
  NodePacks<2 * Dim, Dim> found;
  basis.template sum<2 * Dim, true>(nodes, k, s.motion.data(), found);
  std::array<double, 2 * Dim> motion;
  Mat<Dim> gradient;
  found.template get<Dim>(motion, gradient);
  return gradient;
}

template <class B, int Dim>
std::size_t velocity_gradient(KernelState<Dim>& s, const Block& block, const Instant&) {
  const B& basis = basis_of<B>(s);
  const auto L = components<Dim * Dim>(s, Column::velocity_gradient);
  for_chunks(basis, block, [&](std::size_t begin, std::size_t n, auto& nodes) {
    for (std::size_t k = 0; k < n; ++k) {
      const Mat<Dim> gradient = gradient_at(s, basis, nodes, k);
      for (std::size_t c = 0; c < Dim * Dim; ++c) L[c][begin + k] = gradient[c];
    }
  });
  return none_bad;
}

/// L (I + dt L)^-1.
template <int Dim>
ASSAY_INLINE Mat<Dim> convected_by(const Mat<Dim>& L, double dt) {
  Mat<Dim> step;
  for (std::size_t c = 0; c < Dim * Dim; ++c) step[c] = (c % (Dim + 1) == 0 ? 1 : 0) + dt * L[c];
  return product<Dim>(L, inverse<Dim>(step));
}

enum class Carried { moment, gradient, convected, fitted };

template <class B, Carried Kind, int Dim>
ASSAY_INLINE Mat<Dim> carried_by(const KernelState<Dim>& s, const B& basis, const typename B::Nodes& nodes,
                                 std::size_t k, double dt) {
  if constexpr (Kind == Carried::gradient || Kind == Carried::convected) {
    const Mat<Dim> gradient = gradient_at(s, basis, nodes, k);
    return Kind == Carried::convected ? convected_by<Dim>(gradient, dt) : gradient;
  } else {
    const Mat<Dim> moment = basis.template moment<2 * Dim>(nodes, k, s.motion.data());
    if constexpr (Kind == Carried::moment) return moment;
    return convected_by<Dim>(product<Dim>(moment, inverse<Dim>(basis.spread(nodes, k))), dt);
  }
}

template <class B, Carried Kind, int Dim>
std::size_t carry(KernelState<Dim>& s, const Block& block, const Instant& now) {
  const B& basis = basis_of<B>(s);
  const auto C = components<Dim * Dim>(s, Column::affine);
  for_chunks(basis, block, [&](std::size_t begin, std::size_t n, auto& nodes) {
    if constexpr (Kind == Carried::moment || Kind == Carried::fitted) basis.slopes_to_moments(n, nodes);
    for (std::size_t k = 0; k < n; ++k) {
      const Mat<Dim> found = carried_by<B, Kind>(s, basis, nodes, k, now.dt);
      for (std::size_t c = 0; c < Dim * Dim; ++c) C[c][begin + k] = found[c];
    }
  });
  return none_bad;
}

template <class B, int Dim>
std::size_t first_moment(KernelState<Dim>& s, const Block& block, const Instant&) {
  const B& basis = basis_of<B>(s);
  const auto C = components<Dim * Dim>(s, Column::affine);
  typename B::Nodes nodes;
  for (std::size_t p = block.begin; p < block.end; ++p) {
    basis.expand(p, 1, nodes);
    const Mat<Dim> moment = product<Dim>(load(C, p), basis.spread(nodes, 0));
    for (std::size_t c = 0; c < Dim * Dim; ++c) C[c][p] = moment[c];
  }
  return none_bad;
}

template <class B, int Dim>
std::size_t corners(KernelState<Dim>& s, const Block& block, const Instant& now) {
  const B& basis = basis_of<B>(s);
  double* column = s.column(Column::corners);
  for (std::size_t p = block.begin; p < block.end; ++p) {
    std::array<std::array<double, 2 * Dim>, 1 << Dim> motion;
    basis.template at_corners<2 * Dim>(p, s.motion.data(), motion);
    for (std::size_t k = 0; k < corner_components<Dim>; ++k) {
      column[k * s.particles + p] += now.dt * motion[k / Dim][k % Dim];
    }
  }
  return none_bad;
}

}  // namespace assay::mpm::ASSAY_INSTRUCTIONS
