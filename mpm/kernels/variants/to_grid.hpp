// SPDX-License-Identifier: BSD-3-Clause
// From particles to the grid: weights, mass and momentum, forces.
#pragma once

#include "mpm/basis/corners.hpp"
#include "mpm/kernels/affine.hpp"
#include "mpm/kernels/variants/basis_of.hpp"

namespace assay::mpm::ASSAY_INSTRUCTIONS {

template <class B, int Dim>
ASSAY_INLINE bool place_particle(KernelState<Dim>& s, B& basis, std::size_t p, bool total, bool own_domain) {
  if constexpr (B::traits.moves_corners) {
    Corners<Dim> corners;
    const double* column = s.column(Column::corners);
    for (std::size_t k = 0; k < corner_components<Dim>; ++k) corners[k / Dim][k % Dim] = column[k * s.particles + p];
    return basis.place(p, corners);
  } else {
    const double* at = s.column(total ? Column::reference_position : Column::position);
    Vec<Dim> x;
    for (std::size_t d = 0; d < Dim; ++d) x[d] = at[d * s.particles + p];
    Mat<Dim> F{};
    if (B::traits.uses_deformation && !total) {
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
  const std::size_t b = block.begin / block_size;
  basis.reach(block.begin, block.end, s.reach[b]);
  if constexpr (requires { basis.has_on_line(block.begin, block.end); }) {
    if (!s.on_lines.empty()) s.on_lines[b] = basis.has_on_line(block.begin, block.end) ? 1 : 0;
  }
  return bad;
}

/// m C of a particle, row-major.
template <class B, Around Kind, int Dim>
ASSAY_INLINE Mat<Dim> carried(const B& basis, const typename B::Nodes& nodes, std::size_t k, double mass,
                              const double* around, std::size_t particles) {
  Mat<Dim> C;
  for (std::size_t c = 0; c < Dim * Dim; ++c) C[c] = around[c * particles + k];
  if constexpr (Kind == Around::moment) C = product<Dim>(C, inverse<Dim>(basis.spread(nodes, k)));
  for (double& component : C) component *= mass;
  return C;
}

/// Mass and momentum of n particles; slopes become moments where they carry anything.
template <class B, Around Kind, int Dim>
ASSAY_INLINE void add_momentum(const KernelState<Dim>& s, const B& basis, std::size_t begin, std::size_t n,
                               typename B::Nodes& nodes, double* inertia) {
  constexpr std::size_t S = GridField<Dim + 1>::stride;
  const double *mass = s.column(Column::mass) + begin, *v = s.column(Column::velocity) + begin;
  Given<Dim + 1, Dim> given;
  ASSAY_INDEPENDENT
  for (std::size_t k = 0; k < n; ++k) {
    given.value[k][0] = mass[k];
    for (std::size_t d = 0; d < Dim; ++d) given.value[k][1 + d] = mass[k] * v[d * s.particles + k];
    for (std::size_t c = Dim + 1; c < S; ++c) given.value[k][c] = 0;
  }
  if constexpr (Kind == Around::nothing) {
    basis.template add_all<Dim + 1, false>(nodes, n, given, inertia);
  } else {
    const double* around = s.column(affine_column(s.method)) + begin;
    ASSAY_INDEPENDENT
    for (std::size_t k = 0; k < n; ++k) {
      const Mat<Dim> C = carried<B, Kind, Dim>(basis, nodes, k, mass[k], around, s.particles);
      for (std::size_t d = 0; d < Dim; ++d) {
        given.other[d][k][0] = 0;
        for (std::size_t i = 0; i < Dim; ++i) given.other[d][k][1 + i] = C[i * Dim + d];
        for (std::size_t c = Dim + 1; c < S; ++c) given.other[d][k][c] = 0;
      }
    }
    basis.slopes_to_moments(n, nodes);
    basis.template add_all_affine<Dim + 1>(nodes, n, given, inertia);
  }
}

template <class B, Around Kind, int Dim>
std::size_t momentum(KernelState<Dim>& s, const Block& block, const Instant&) {
  const B& basis = basis_of<B>(s);
  for_chunks(basis, block, [&](std::size_t begin, std::size_t n, auto& nodes) {
    add_momentum<B, Kind>(s, basis, begin, n, nodes, block.inertia);
  });
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
ASSAY_INLINE void forces_of(const KernelState<Dim>& s, std::size_t begin, std::size_t n, Given<Dim, Dim>& given) {
  const double *F = s.column(Column::deformation_gradient), *sigma = s.column(s.stress_of_forces),
               *volume = s.column(Column::volume), *mass = s.column(Column::mass),
               *b = WithBody ? s.column(Column::body_force) : nullptr;
  std::size_t row[Dim * Dim];
  for (std::size_t c = 0; c < Dim * Dim; ++c) {
    row[c] = Dim == 2 || s.stress_of_forces == Column::stress ? stress_index<Dim>(c / Dim, c % Dim) : c;
  }
  ASSAY_INDEPENDENT
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t p = begin + k;
    Mat<Dim> cauchy, deformation;
    for (std::size_t c = 0; c < Dim * Dim; ++c) {
      cauchy[c] = sigma[(Dim == 2 ? c : row[c]) * s.particles + p];
      deformation[c] = F[c * s.particles + p];
    }
    const Mat<Dim> stress = weighted_stress<Dim>(cauchy, deformation, volume[p], Total);
    for (std::size_t i = 0; i < GridField<Dim>::stride; ++i) {
      given.value[k][i] = WithBody && i < Dim ? mass[p] * b[i * s.particles + p] : 0;
      for (std::size_t d = 0; d < Dim; ++d) given.other[d][k][i] = i < Dim ? stress[i * Dim + d] : 0;
    }
  }
}

template <class B, bool WithBody, int Dim>
ASSAY_INLINE void add_force(const KernelState<Dim>& s, const B& basis, std::size_t begin, std::size_t n,
                            const typename B::Nodes& nodes, double* force) {
  Given<Dim, Dim> given;
  if (s.method.is_total()) {
    forces_of<WithBody, true>(s, begin, n, given);
  } else {
    forces_of<WithBody, false>(s, begin, n, given);
  }
  basis.template add_all<Dim, true>(nodes, n, given, force);
}

template <class B, bool WithBody, int Dim>
std::size_t force(KernelState<Dim>& s, const Block& block, const Instant&) {
  const B& basis = basis_of<B>(s);
  for_chunks(basis, block, [&](std::size_t begin, std::size_t n, auto& nodes) {
    add_force<B, WithBody>(s, basis, begin, n, nodes, block.force);
  });
  return none_bad;
}

/// Both, for which the weights are made once.
template <class B, Around Kind, bool WithBody, int Dim>
std::size_t momentum_and_force(KernelState<Dim>& s, const Block& block, const Instant&) {
  const B& basis = basis_of<B>(s);
  for_chunks(basis, block, [&](std::size_t begin, std::size_t n, auto& nodes) {
    add_force<B, WithBody>(s, basis, begin, n, nodes, block.force);
    add_momentum<B, Kind>(s, basis, begin, n, nodes, block.inertia);
  });
  return none_bad;
}

/// Of each particle m phi_ip phi_jp for each pair of its nodes i, j of which i has a row.
template <class B, int Dim>
void add_mass_rows(const KernelState<Dim>& s, const Block& block, const MassRows<Dim>& rows) {
  constexpr std::size_t W = B::nodes_across, span = 2 * W - 1, planes = Dim == 2 ? 1 : W;
  const B& basis = basis_of<B>(s);
  const auto steps = basis.steps();
  const double* mass = s.column(Column::mass);
  for_chunks(basis, block, [&](std::size_t begin, std::size_t n, auto& nodes) {
    for (std::size_t k = 0; k < n; ++k) {
      const auto across = [&](std::size_t plane, std::size_t row) {  // weight of a line of nodes
        return nodes.value(k, 1, row) * (Dim == 3 ? nodes.value(k, Dim - 1, plane) : 1);
      };
      for (std::size_t line = 0; line < planes * W; ++line) {
        const std::size_t z = line / W, y = line % W;
        const double of_line = mass[begin + k] * across(z, y);
        for (std::size_t x = 0; x < W; ++x) {
          const std::size_t i = static_cast<std::size_t>(nodes.node[k]) + x + y * steps[1] + z * steps[Dim - 1];
          if (!rows.holds(i)) continue;
          double* row = rows.row(i);
          const double of_node = of_line * nodes.value(k, 0, x);
          for (std::size_t other = 0; other < planes * W; ++other) {
            const std::size_t oz = other / W, oy = other % W;
            const double of_other = of_node * across(oz, oy);
            const std::size_t first =
                (W - 1 - x) + span * ((oy + W - 1 - y) + (Dim == 3 ? span * (oz + W - 1 - z) : 0));
            for (std::size_t ox = 0; ox < W; ++ox)
              row[(first + ox) * rows_at_once<Dim>] += of_other * nodes.value(k, 0, ox);
          }
        }
      }
    }
  });
}

template <class B, int Dim>
void multiply_mass(const KernelState<Dim>& s, const Block& block, const double* x) {
  const B& basis = basis_of<B>(s);
  const double* mass = s.column(Column::mass);
  for_chunks(basis, block, [&](std::size_t begin, std::size_t n, auto& nodes) {
    for (std::size_t k = 0; k < n; ++k) {
      NodePacks<Dim, Dim> found;
      basis.template sum<Dim, false>(nodes, k, x, found);
      found.value *= mass[begin + k];
      basis.template add<Dim, false>(nodes, k, found, block.force);
    }
  });
}

}  // namespace assay::mpm::ASSAY_INSTRUCTIONS
