// SPDX-License-Identifier: BSD-3-Clause
// From the grid to particles: positions, velocities, gradients, corners, the velocity around a particle.
#pragma once

#include "mpm/affine.hpp"
#include "mpm/corners.hpp"
#include "mpm/kernels/basis_of.hpp"

namespace assay::mpm::ASSAY_INSTRUCTIONS {

/// Grid motion at a few particles, and its slopes in each direction.
template <int Dim>
struct MotionOfParticles {
  static constexpr int stride = GridField<2 * Dim>::stride;
  double value[particles_at_once][stride], slope[Dim][particles_at_once][stride];
};

/// Positions, velocities, L. Whether all positions and velocities are numbers.
template <Velocity Kind, bool Gradient, int Dim>
ASSAY_INLINE bool move(KernelState<Dim>& s, std::size_t begin, std::size_t n, const MotionOfParticles<Dim>& motion,
                       const Instant& now) {
  const double flip = s.method.flip, dt = now.dt, kick = now.kick;
  int lost = 0;
  for (std::size_t d = 0; d < Dim; ++d) {
    double *x = s.column(Column::position, static_cast<int>(d)) + begin,
           *v = s.column(Column::velocity, static_cast<int>(d)) + begin;
    ASSAY_INDEPENDENT
    for (std::size_t k = 0; k < n; ++k) {
      const double of_grid = motion.value[k][d];
      x[k] += dt * of_grid;
      if constexpr (Kind == Velocity::of_grid) {
        v[k] = of_grid;
      } else {
        const double kept = v[k] + kick * motion.value[k][Dim + d];
        v[k] = Kind == Velocity::kept ? kept : flip * kept + (1 - flip) * of_grid;
      }
    }
    for (std::size_t k = 0; k < n; ++k) lost |= 0 * (x[k] + v[k]) != 0 ? 1 : 0;
    if constexpr (Gradient) {
      for (std::size_t i = 0; i < Dim; ++i) {
        double* L = s.column(Column::velocity_gradient, static_cast<int>(i * Dim + d)) + begin;
        ASSAY_INDEPENDENT
        for (std::size_t k = 0; k < n; ++k) L[k] = motion.slope[d][k][i];
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
  constexpr int S = GridField<2 * Dim>::stride;
  const B& basis = basis_of<B>(s);
  typename B::Nodes nodes;
  MotionOfParticles<Dim> motion;
  double power = 0;
  std::size_t bad = none_bad;
  for (std::size_t begin = block.begin; begin < block.end; begin += particles_at_once) {
    const std::size_t n = count_at(begin, block);
    basis.expand(begin, n, nodes);
    for (std::size_t k = 0; k < n; ++k) {
      NodePacks<2 * Dim, Dim> found;
      basis.template sum<2 * Dim, Gradient>(nodes, k, s.motion.data(), found);
      store<S>(motion.value[k], found.value);
      for (std::size_t d = 0; Gradient && d < Dim; ++d) store<S>(motion.slope[d][k], found.other[d]);
    }
    if constexpr (Power) {
      const double *mass = s.column(Column::mass) + begin, *b = s.column(Column::body_force) + begin;
      for (std::size_t k = 0; k < n; ++k) {
        for (std::size_t d = 0; d < Dim; ++d) power += mass[k] * b[d * s.particles + k] * motion.value[k][d];
      }
    }
    if (!move<Kind, Gradient>(s, begin, n, motion, now) && bad == none_bad) bad = first_lost(s, begin, n);
  }
  if constexpr (Power) s.block_power[block.begin / block_size] = power;
  return bad;
}

/// L = sum_i v_i (x) grad phi_ip of the grid velocity.
template <class B, int Dim>
ASSAY_INLINE Mat<Dim> gradient_at(const KernelState<Dim>& s, const B& basis, std::size_t p) {
  std::array<double, 2 * Dim> motion;
  Mat<Dim> gradient;
  basis.template gather<2 * Dim, Dim>(p, s.motion.data(), motion, gradient);
  return gradient;
}

template <class B, int Dim>
std::size_t velocity_gradient(KernelState<Dim>& s, const Block& block, const Instant&) {
  const B& basis = basis_of<B>(s);
  const auto L = components<Dim * Dim>(s, Column::velocity_gradient);
  for (std::size_t p = block.begin; p < block.end; ++p) {
    const Mat<Dim> gradient = gradient_at(s, basis, p);
    for (std::size_t c = 0; c < Dim * Dim; ++c) L[c][p] = gradient[c];
  }
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
std::size_t carry(KernelState<Dim>& s, const Block& block, const Instant& now) {
  const B& basis = basis_of<B>(s);
  const auto C = components<Dim * Dim>(s, Column::affine);
  for (std::size_t p = block.begin; p < block.end; ++p) {
    Mat<Dim> found;
    if constexpr (Kind == Carried::moment) {
      found = basis.template first_moment<2 * Dim>(p, s.motion.data());
    } else if constexpr (Kind == Carried::fitted) {
      Mat<Dim> first, second;
      basis.template moments<2 * Dim>(p, s.motion.data(), first, second);
      found = product<Dim>(first, inverse<Dim>(second));
    } else {
      found = gradient_at(s, basis, p);
    }
    if constexpr (Kind == Carried::fitted || Kind == Carried::convected) found = convected_by<Dim>(found, now.dt);
    for (std::size_t c = 0; c < Dim * Dim; ++c) C[c][p] = found[c];
  }
  return none_bad;
}

template <class B, int Dim>
std::size_t first_moment(KernelState<Dim>& s, const Block& block, const Instant&) {
  const B& basis = basis_of<B>(s);
  const auto C = components<Dim * Dim>(s, Column::affine);
  for (std::size_t p = block.begin; p < block.end; ++p) {
    const Mat<Dim> moment = product<Dim>(load(C, p), basis.second_moment(p));
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
