// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/passes_to_grid.hpp"

#include "mpm/affine.hpp"
#include "mpm/bases.hpp"
#include "mpm/blocks.hpp"
#include "mpm/column_access.hpp"

namespace assay::mpm {

template <class B, int Dim>
void place_corners(State<Dim>& s, B& basis, std::size_t begin, std::size_t end, FirstBad& outside) {
  const auto columns = components<corner_components<Dim>>(s, Column::corners);
  for (std::size_t p = begin; p < end; ++p) {
    Corners<Dim> corners;
    for (std::size_t k = 0; k < columns.size(); ++k) corners[k / Dim][k % Dim] = columns[k][p];
    if (!basis.place(p, corners)) outside.report(p);
  }
}

/// The weights of a block of particles, whose domains are all alike or one each.
template <class B, int Dim>
void place_block(State<Dim>& s, B& basis, std::size_t begin, std::size_t end, FirstBad& outside) {
  const bool total = s.setup.method.is_total();
  const auto x = components<Dim>(s, total ? Column::reference_position : Column::position);
  const auto F = components<Dim * Dim>(s, Column::deformation_gradient);
  Mat<Dim> undeformed{};
  for (std::size_t d = 0; d < Dim; ++d) undeformed[d * Dim + d] = 1;
  const auto F_of = [&](std::size_t p) { return B::uses_deformation && !total ? load(F, p) : undeformed; };
  if constexpr (B::domain_components > 0) {
    if (s.has(Column::domain)) {
      const auto half = components<static_cast<int>(B::domain_components)>(s, Column::domain);
      for (std::size_t p = begin; p < end; ++p) {
        if (!basis.place(p, load(x, p), F_of(p), load(half, p))) outside.report(p);
      }
      return;
    }
  }
  for (std::size_t p = begin; p < end; ++p) {
    if (!basis.place(p, load(x, p), F_of(p))) outside.report(p);
  }
}

template <class B, int Dim>
Pass<Dim> weights_pass(Formulation formulation, bool domains_differ) {
  Pass<Dim> pass;
  pass.name = "weights";
  pass.doc = "nodes, phi_ip and grad phi_ip of every particle, shared by the passes of the step";
  pass.called_for_by = "method.basis";
  const bool total = formulation == Formulation::total;
  if (total) pass.doc = "nodes, phi_ip and grad phi_ip of every particle in the reference configuration";
  pass.once = total;
  pass.reads = {MovesCorners<B> ? Column::corners : total ? Column::reference_position : Column::position};
  if (B::uses_deformation && !total) pass.reads.push_back(Column::deformation_gradient);
  if (domains_differ && B::domain_components > 0) pass.reads.push_back(Column::domain);
  pass.writes = {Column::weights};
  pass.bind = [](State<Dim>& s) -> Kernel {
    B& basis = basis_of<B>(s);
    return [&s, &basis](const Instant&) {
      FirstBad outside;
      for_blocks(s.particles, s.setup.threads, [&](std::size_t begin, std::size_t end) {
        if constexpr (MovesCorners<B>) {
          place_corners(s, basis, begin, end, outside);
        } else {
          place_block(s, basis, begin, end, outside);
        }
      });
      if (const auto p = outside.found()) {
        s.finding = Finding{Finding::Kind::unstable,
                            MovesCorners<B> ? "a corner of a domain left the grid, or a domain turned inside out"
                                            : "a particle or a corner of its domain left the grid",
                            static_cast<std::int64_t>(*p)};
      }
    };
  };
  return pass;
}

/// Particles that never move give the grid their mass once.
template <class B, int Dim>
std::vector<double> mass_of_held(const State<Dim>& s) {
  const Seeds<Dim>& seeds = s.setup.seeds;
  const Tensor turn = rotation_about_z(seeds.angle);  // of the domain, as a rigid motion would turn it
  Mat<Dim> F{};
  for (std::size_t i = 0; i < Dim; ++i) {
    for (std::size_t d = 0; d < Dim; ++d) F[i * Dim + d] = turn(static_cast<int>(i), static_cast<int>(d));
  }
  GridField<1> mass;
  mass.allocate(s.setup.grid.nodes());
  B basis(s.setup.grid, seeds.half_size, 1);
  for (const auto& X : seeds.held) {
    if (basis.place(0, X, F)) basis.template scatter<1, 0>(0, {s.setup.density * seeds.volume()}, {}, mass);
  }
  return std::vector<double>(mass.data(), mass.data() + mass.nodes());
}

template <class B, bool Affine, int Dim>
void scatter_momentum(State<Dim>& s, const B& basis, Column affine) {
  const double* mass = s.column(Column::mass);
  const auto v = components<Dim>(s, Column::velocity);
  for (std::size_t p = 0; p < s.particles; ++p) {
    std::array<double, Dim + 1> A;
    A[0] = mass[p];
    for (std::size_t d = 0; d < Dim; ++d) A[d + 1] = mass[p] * v[d][p];
    if constexpr (Affine) {
      Mat<Dim> C = load(components<Dim * Dim>(s, affine), p);
      if (s.setup.method.affine == mpm::Affine::moment) C = product<Dim>(C, inverse<Dim>(second_moment<Dim>(basis, p)));
      for (double& c : C) c *= mass[p];
      scatter_affine(basis, p, A, C, s.inertia);
    } else {
      basis.template scatter<Dim + 1, 0>(p, A, {}, s.inertia);
    }
  }
}

template <class B, int Dim>
Pass<Dim> particles_to_grid_pass(const Method& method, bool hold_outside) {
  Pass<Dim> pass;
  pass.name = "particles_to_grid";
  pass.doc = method.is_affine() ? "nodal mass and momentum, of the velocity around the particles, too"
                                : "nodal mass and momentum";
  pass.called_for_by = method.is_affine() ? "method.transfer" : "method";
  pass.reads = {Column::weights, Column::mass, Column::velocity};
  const Column affine = affine_column(method);
  if (method.is_affine()) pass.reads.push_back(affine);
  pass.grid_fields = {"mass", "momentum"};
  pass.bind = [hold_outside, affine, is_affine = method.is_affine()](State<Dim>& s) -> Kernel {
    const B& basis = basis_of<B>(s);
    if (hold_outside) s.held_mass = mass_of_held<B>(s);
    const auto scatter = is_affine ? scatter_momentum<B, true, Dim> : scatter_momentum<B, false, Dim>;
    return [&s, &basis, hold_outside, scatter, affine](const Instant&) {
      s.inertia.zero();
      if (hold_outside) {
        for (std::size_t i = 0; i < s.held_mass.size(); ++i) s.inertia.node(i)[0] = s.held_mass[i];
      }
      scatter(s, basis, affine);
      s.inertia.reduce_ghosts();
    };
  };
  return pass;
}

/// V sigma of the gradients that the basis gives: in the current configuration, or V0 P.
template <int Dim>
Mat<Dim> weighted_stress(const std::array<double*, stress_components<Dim>>& sigma, const Mat<Dim>& F, double V0,
                         std::size_t p, bool total) {
  const double V = V0 * determinant<Dim>(F);
  Mat<Dim> cauchy;
  for (std::size_t i = 0; i < Dim; ++i) {
    for (std::size_t d = 0; d < Dim; ++d) cauchy[i * Dim + d] = V * sigma[stress_index<Dim>(i, d)][p];
  }
  return total ? product<Dim>(cauchy, inverse_transpose<Dim>(F, determinant<Dim>(F))) : cauchy;
}

template <class B, bool WithBody, int Dim>
void scatter_forces(State<Dim>& s, const B& basis) {
  s.force.zero();
  const bool total = s.setup.method.is_total();
  const auto F = components<Dim * Dim>(s, Column::deformation_gradient);
  const auto sigma = components<stress_components<Dim>>(s, Column::stress);
  const double *volume = s.column(Column::volume), *mass = s.column(Column::mass);
  std::array<double*, Dim> b{};
  if constexpr (WithBody) b = components<Dim>(s, Column::body_force);
  for (std::size_t p = 0; p < s.particles; ++p) {
    std::array<double, Dim> A{};
    if constexpr (WithBody) {
      for (std::size_t i = 0; i < Dim; ++i) A[i] = mass[p] * b[i][p];
    }
    Mat<Dim> stress = weighted_stress<Dim>(sigma, load(F, p), volume[p], p, total);
    for (double& component : stress) component = -component;
    basis.template scatter<Dim, Dim>(p, A, stress, s.force);
  }
  s.force.reduce_ghosts();
}

template <class B, int Dim>
Pass<Dim> force_pass(Formulation formulation, bool with_body_force) {
  Pass<Dim> pass;
  pass.name = "grid_forces";
  pass.doc = with_body_force ? "nodal internal and body force" : "nodal internal force";
  if (formulation == Formulation::total) pass.doc += ", by the first Piola-Kirchhoff stress";
  pass.called_for_by = "method";
  pass.reads = {Column::weights, Column::stress, Column::volume, Column::deformation_gradient};
  if (with_body_force) {
    pass.reads.push_back(Column::mass);
    pass.reads.push_back(Column::body_force);
  }
  pass.grid_fields = {"force"};
  pass.bind = [with_body_force](State<Dim>& s) -> Kernel {
    const B& basis = basis_of<B>(s);
    if (with_body_force) return [&s, &basis](const Instant&) { scatter_forces<B, true>(s, basis); };
    return [&s, &basis](const Instant&) { scatter_forces<B, false>(s, basis); };
  };
  return pass;
}

#define ASSAY_PASSES(BASIS, DIM)                                                   \
  template Pass<DIM> weights_pass<BASIS<DIM>, DIM>(Formulation, bool);             \
  template Pass<DIM> particles_to_grid_pass<BASIS<DIM>, DIM>(const Method&, bool); \
  template Pass<DIM> force_pass<BASIS<DIM>, DIM>(Formulation, bool);

ASSAY_FOR_EACH_BASIS(ASSAY_PASSES)
#undef ASSAY_PASSES

}  // namespace assay::mpm
