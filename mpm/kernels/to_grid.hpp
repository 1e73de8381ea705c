// SPDX-License-Identifier: BSD-3-Clause
// From particles to the grid: weights, mass and momentum, forces.
#pragma once

#include "mpm/affine.hpp"
#include "mpm/corners.hpp"
#include "mpm/kernels/basis_of.hpp"

namespace assay::mpm::ASSAY_INSTRUCTIONS {

template <class B, int Dim>
ASSAY_INLINE bool place_particle(KernelState<Dim>& s, B& basis, std::size_t p, bool total, bool own_domain) {
  if constexpr (MovesCorners<B>) {
    Corners<Dim> corners;
    const double* column = s.column(Column::corners);
    for (std::size_t k = 0; k < corner_components<Dim>; ++k) corners[k / Dim][k % Dim] = column[k * s.particles + p];
    return basis.place(p, corners);
  } else {
    const double* at = s.column(total ? Column::reference_position : Column::position);
    Vec<Dim> x;
    for (std::size_t d = 0; d < Dim; ++d) x[d] = at[d * s.particles + p];
    Mat<Dim> F{};
    if (B::uses_deformation && !total) {
      const double* column = s.column(Column::deformation_gradient);
      for (std::size_t c = 0; c < Dim * Dim; ++c) F[c] = column[c * s.particles + p];
    } else {
      for (std::size_t d = 0; d < Dim; ++d) F[d * Dim + d] = 1;
    }
    if constexpr (B::domain_components > 0) {
      if (own_domain) {
        std::array<double, B::domain_components> half;
        const double* column = s.column(Column::domain);
        for (std::size_t c = 0; c < half.size(); ++c) half[c] = column[c * s.particles + p];
        return basis.place(p, x, F, half);
      }
    }
    return basis.place(p, x, F);
  }
}

template <class B, int Dim>
std::size_t place(KernelState<Dim>& s, const Block& block, const Instant&) {
  B& basis = basis_of<B>(s);
  const bool total = s.method.is_total(), own_domain = s.has(Column::domain);
  std::size_t bad = none_bad;
  for (std::size_t p = block.begin; p < block.end; ++p) {
    if (!place_particle<B>(s, basis, p, total, own_domain) && bad == none_bad) bad = p;
  }
  NodeRange& nodes = s.reach[block.begin / block_size];
  basis.reach(block.begin, block.end, nodes.first, nodes.end);
  return bad;
}

enum class Around { gradient, moment };

/// Of particles that do not carry the velocity around them.
template <class B, int Dim>
std::size_t momentum(KernelState<Dim>& s, const Block& block, const Instant&) {
  constexpr int S = GridField<Dim + 1>::stride;
  const B& basis = basis_of<B>(s);
  const double *mass = s.column(Column::mass), *v = s.column(Column::velocity);
  typename B::Nodes nodes;
  for (std::size_t begin = block.begin; begin < block.end; begin += particles_at_once) {
    const std::size_t n = count_at(begin, block);
    double A[particles_at_once][S] = {};
    for (std::size_t k = 0; k < n; ++k) {
      A[k][0] = mass[begin + k];
      for (std::size_t d = 0; d < Dim; ++d) A[k][1 + d] = mass[begin + k] * v[d * s.particles + begin + k];
    }
    basis.expand(begin, n, nodes);
    for (std::size_t k = 0; k < n; ++k) {
      NodePacks<Dim + 1, Dim> value;
      load<S>(value.value, A[k]);
      basis.template add<Dim + 1, false>(nodes, k, value, block.inertia);
    }
  }
  return none_bad;
}

/// Of particles that do.
template <class B, Around Kind, int Dim>
std::size_t affine_momentum(KernelState<Dim>& s, const Block& block, const Instant&) {
  constexpr int S = GridField<Dim + 1>::stride;
  const B& basis = basis_of<B>(s);
  const double *mass = s.column(Column::mass), *v = s.column(Column::velocity),
               *around = s.column(affine_column(s.method));
  typename B::Nodes nodes;
  for (std::size_t begin = block.begin; begin < block.end; begin += particles_at_once) {
    const std::size_t n = count_at(begin, block);
    double A[particles_at_once][S] = {}, B_of[Dim][particles_at_once][S] = {};
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t p = begin + k;
      Mat<Dim> C;
      for (std::size_t c = 0; c < Dim * Dim; ++c) C[c] = around[c * s.particles + p];
      if constexpr (Kind == Around::moment) C = product<Dim>(C, inverse<Dim>(basis.second_moment(p)));
      A[k][0] = mass[p];
      for (std::size_t i = 0; i < Dim; ++i) {
        A[k][1 + i] = mass[p] * v[i * s.particles + p];
        for (std::size_t d = 0; d < Dim; ++d) B_of[d][k][1 + i] = mass[p] * C[i * Dim + d];
      }
    }
    basis.expand(begin, n, nodes);
    basis.slopes_to_moments(n, nodes);
    for (std::size_t k = 0; k < n; ++k) {
      NodePacks<Dim + 1, Dim> value;
      load<S>(value.value, A[k]);
      for (std::size_t d = 0; d < Dim; ++d) load<S>(value.other[d], B_of[d][k]);
      basis.template add_affine<Dim + 1>(nodes, k, value, block.inertia);
    }
  }
  return none_bad;
}

/// -V sigma of the gradients that the basis gives: in the current configuration; or -V0 P, P = sigma cof F.
template <int Dim>
ASSAY_INLINE Mat<Dim> weighted_stress(const Mat<Dim>& cauchy, const Mat<Dim>& F, double V0, bool total) {
  Mat<Dim> force{};
  if (total) {
    force = product<Dim>(cauchy, inverse_transpose<Dim>(F, 1));  // cof F = det F times F^-T
    for (double& component : force) component *= -V0;
  } else {
    const double V = -V0 * determinant<Dim>(F);
    for (std::size_t c = 0; c < Dim * Dim; ++c) force[c] = V * cauchy[c];
  }
  return force;
}

/// What n particles give to the nodes: m b, and the columns of the weighted stress.
template <bool WithBody, bool Total, int Dim>
ASSAY_INLINE void forces_of(const KernelState<Dim>& s, std::size_t begin, std::size_t n,
                            double (&A)[particles_at_once][GridField<Dim>::stride],
                            double (&B)[Dim][particles_at_once][GridField<Dim>::stride]) {
  const double *F = s.column(Column::deformation_gradient), *sigma = s.column(Column::stress),
               *volume = s.column(Column::volume), *mass = s.column(Column::mass),
               *b = WithBody ? s.column(Column::body_force) : nullptr;
  ASSAY_INDEPENDENT
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t p = begin + k;
    Mat<Dim> cauchy, deformation;
    for (std::size_t c = 0; c < Dim * Dim; ++c) {
      cauchy[c] = sigma[stress_index<Dim>(c / Dim, c % Dim) * s.particles + p];
      deformation[c] = F[c * s.particles + p];
    }
    const Mat<Dim> stress = weighted_stress<Dim>(cauchy, deformation, volume[p], Total);
    for (std::size_t i = 0; i < Dim; ++i) {
      A[k][i] = WithBody ? mass[p] * b[i * s.particles + p] : 0;
      for (std::size_t d = 0; d < Dim; ++d) B[d][k][i] = stress[i * Dim + d];
    }
  }
}

template <class Basis, bool WithBody, int Dim>
std::size_t force(KernelState<Dim>& s, const Block& block, const Instant&) {
  constexpr int S = GridField<Dim>::stride;
  const Basis& basis = basis_of<Basis>(s);
  const bool total = s.method.is_total();
  typename Basis::Nodes nodes;
  for (std::size_t begin = block.begin; begin < block.end; begin += particles_at_once) {
    const std::size_t n = count_at(begin, block);
    double A[particles_at_once][S] = {}, B[Dim][particles_at_once][S] = {};
    if (total) {
      forces_of<WithBody, true>(s, begin, n, A, B);
    } else {
      forces_of<WithBody, false>(s, begin, n, A, B);
    }
    basis.expand(begin, n, nodes);
    for (std::size_t k = 0; k < n; ++k) {
      NodePacks<Dim, Dim> value;
      load<S>(value.value, A[k]);
      for (std::size_t d = 0; d < Dim; ++d) load<S>(value.other[d], B[d][k]);
      basis.template add<Dim, true>(nodes, k, value, block.force);
    }
  }
  return none_bad;
}

template <class B, int Dim>
void multiply_mass(const KernelState<Dim>& s, const Block& block, const double* x) {
  const B& basis = basis_of<B>(s);
  const double* mass = s.column(Column::mass);
  typename B::Nodes nodes;
  for (std::size_t begin = block.begin; begin < block.end; begin += particles_at_once) {
    const std::size_t n = count_at(begin, block);
    basis.expand(begin, n, nodes);
    for (std::size_t k = 0; k < n; ++k) {
      NodePacks<Dim, Dim> found;
      basis.template sum<Dim, false>(nodes, k, x, found);
      found.value *= mass[begin + k];
      basis.template add<Dim, false>(nodes, k, found, block.force);
    }
  }
}

}  // namespace assay::mpm::ASSAY_INSTRUCTIONS
