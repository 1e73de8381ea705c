// SPDX-License-Identifier: BSD-3-Clause
// From the grid to particles: positions, velocities, gradients, corners, the velocity around a particle.
#pragma once

#include "mpm/basis/corners.hpp"
#include "mpm/kernels/affine.hpp"
#include "mpm/kernels/variants/basis_of.hpp"

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
    double *x = s.column(Column::position, d) + begin, *v = s.column(Column::velocity, d) + begin;
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
        double* L = s.column(Column::velocity_gradient, i * Dim + d) + begin;
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

/// L (I + dt L)^-1.
template <int Dim>
ASSAY_INLINE Mat<Dim> convected_by(const Mat<Dim>& L, double dt) {
  Mat<Dim> step;
  for (std::size_t c = 0; c < Dim * Dim; ++c) step[c] = (c % (Dim + 1) == 0 ? 1 : 0) + dt * L[c];
  return product<Dim>(L, inverse<Dim>(step));
}

/// Of the velocity around a few particles: B = sum_i w_i v_i (x) r_i and D = sum_i w_i r_i (x) r_i.
template <int Dim>
struct Moments {
  double B[Dim * Dim][particles_at_once], D[Dim * Dim][particles_at_once];

  ASSAY_INLINE void set(std::size_t k, const Mat<Dim>& of_velocity, const Mat<Dim>& of_places) {
    for (std::size_t c = 0; c < Dim * Dim; ++c) B[c][k] = of_velocity[c], D[c][k] = of_places[c];
  }
};

/// The affine velocity of n particles: B D^-1, convected.
template <int Dim>
ASSAY_INLINE void fit(KernelState<Dim>& s, std::size_t begin, std::size_t n, const Moments<Dim>& moments, double dt) {
  double* column = s.column(Column::affine) + begin;
  ASSAY_INDEPENDENT
  for (std::size_t k = 0; k < n; ++k) {
    Mat<Dim> B, D;
    for (std::size_t c = 0; c < Dim * Dim; ++c) B[c] = moments.B[c][k], D[c] = moments.D[c][k];
    const Mat<Dim> C = convected_by<Dim>(product<Dim>(B, inverse<Dim>(D)), dt);
    for (std::size_t c = 0; c < Dim * Dim; ++c) column[c * s.particles + k] = C[c];
  }
}

/// The motion at n particles; what else the same nodes say: corners that move one by one, and [Fits] C.
template <class B, bool Gradient, bool Fits, int Dim>
ASSAY_INLINE void take(KernelState<Dim>& s, const B& basis, const typename B::Nodes& nodes, std::size_t begin,
                       std::size_t n, MotionOfParticles<Gradient, Dim>& motion, double dt) {
  if constexpr (!B::traits.moves_corners) {
    basis.sum_all(nodes, n, s.motion.data(), motion);
  } else {
    double velocity[corner_components<Dim>][particles_at_once];
    Moments<Dim> moments;
    for (std::size_t k = 0; k < n; ++k) {
      NodePacks<2 * Dim, Dim> found;
      const auto visit = [&](std::size_t c, const auto& corner) {
        for (std::size_t d = 0; d < Dim; ++d) velocity[c * Dim + d][k] = corner[d];
      };
      if constexpr (Fits) {
        const Mat<Dim> moment =
            basis.template sum_and_moment<2 * Dim, Gradient>(nodes, k, s.motion.data(), found, visit);
        moments.set(k, moment, basis.spread(nodes, k));
      } else {
        basis.template sum_visiting<2 * Dim, Gradient>(nodes, k, s.motion.data(), found, visit);
      }
      motion.set(k, found);
    }
    for (std::size_t c = 0; c < corner_components<Dim>; ++c) {
      double* at = s.column(Column::corners, c) + begin;
      ASSAY_INDEPENDENT
      for (std::size_t k = 0; k < n; ++k) at[k] += dt * velocity[c][k];
    }
    if constexpr (Fits) fit<Dim>(s, begin, n, moments, dt);
  }
}

/// Power: sum of m b . v of the block, v the grid's velocity at the particle. (The FLIP particle's own velocity is
/// another one: with it the energy account would not close however short the step.)
template <class B, Velocity Kind, bool Gradient, bool Power, bool Fits, int Dim>
std::size_t gather(KernelState<Dim>& s, const Block& block, const Instant& now) {
  const B& basis = basis_of<B>(s);
  MotionOfParticles<Gradient, Dim> motion;
  double power = 0;
  std::size_t bad = none_bad;
  for_chunks(basis, block, [&](std::size_t begin, std::size_t n, auto& nodes) {
    take<B, Gradient, Fits>(s, basis, nodes, begin, n, motion, now.dt);
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

enum class Carried { moment, gradient, convected };

template <class B, Carried Kind, int Dim>
std::size_t carry(KernelState<Dim>& s, const Block& block, const Instant& now) {
  const B& basis = basis_of<B>(s);
  const auto C = components<Dim * Dim>(s, Column::affine);
  for_chunks(basis, block, [&](std::size_t begin, std::size_t n, auto& nodes) {
    if constexpr (Kind == Carried::moment) basis.slopes_to_moments(n, nodes);
    for (std::size_t k = 0; k < n; ++k) {
      Mat<Dim> found;
      if constexpr (Kind == Carried::moment) {
        found = basis.template moment<2 * Dim>(nodes, k, s.motion.data());
      } else {
        found = gradient_at(s, basis, nodes, k);
      }
      if constexpr (Kind == Carried::convected) found = convected_by<Dim>(found, now.dt);
      for (std::size_t c = 0; c < Dim * Dim; ++c) C[c][begin + k] = found[c];
    }
  });
  return none_bad;
}

template <class B, int Dim>
std::size_t carry_fitted(KernelState<Dim>& s, const Block& block, const Instant& now) {
  const B& basis = basis_of<B>(s);
  for_chunks(basis, block, [&](std::size_t begin, std::size_t n, auto& nodes) {
    basis.slopes_to_moments(n, nodes);
    Moments<Dim> moments;
    for (std::size_t k = 0; k < n; ++k) {
      moments.set(k, basis.template moment<2 * Dim>(nodes, k, s.motion.data()), basis.spread(nodes, k));
    }
    fit<Dim>(s, begin, n, moments, now.dt);
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

}  // namespace assay::mpm::ASSAY_INSTRUCTIONS
