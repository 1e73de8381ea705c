// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/compose.hpp"

#include <algorithm>

#include "mpm/affine.hpp"
#include "mpm/mass_matrix.hpp"
#include "mpm/material_batch.hpp"
#include "mpm/passes_affine.hpp"
#include "mpm/passes_body_force.hpp"
#include "mpm/passes_grid.hpp"
#include "mpm/passes_images.hpp"
#include "mpm/passes_inertia.hpp"
#include "mpm/passes_mass.hpp"
#include "mpm/passes_particle.hpp"
#include "mpm/passes_remedies.hpp"
#include "mpm/passes_to_grid.hpp"
#include "mpm/passes_to_particles.hpp"
#include "mpm/passes_traction.hpp"
#include "mpm/sweep.hpp"
#include "mpm/with_basis.hpp"

namespace assay::mpm {

namespace {

template <int Dim>
Pass<Dim> stress_of(const Setup<Dim>& setup) {
  return stress_pass<Dim>(setup.material->state_size() > 0);
}

}  // namespace

/// The order of the passes in each update scheme.
template <int Dim>
std::vector<Pass<Dim>> compose(const Setup<Dim>& setup) {
  std::vector<Pass<Dim>> step;
  const auto add = [&](Pass<Dim> pass) { step.push_back(std::move(pass)); };
  const Method& method = setup.method;
  const auto add_held = [&](const Reaction& reaction) {
    if (setup.hold_outside) add(hold_nodes_pass<Dim>(reaction));
  };
  const auto add_fold = [&](Folded what) {
    if (setup.has_images()) add(fold_images_pass<Dim>(what, setup.accounts));
  };
  const bool body_force = Dim == 2 && setup.body_force;  // lives in the plane
  const Remedies& remedies = setup.remedies;
  const auto add_stress = [&] {
    if (remedies.averages_volume()) {
      add(volume_ratio_pass<Dim>());
      add(average_volume_pass<Dim>(method, remedies.anti_locking));
    }
    add(stress_of(setup));
    if (remedies.has_viscosity()) add(viscosity_pass<Dim>(method));
  };
  const auto add_accounts = [&] {
    if (setup.accounts) add(accounts_pass<Dim>(method, body_force));
  };
  const auto add_gradient_and_stress = [&] {
    add_fold(Folded::inertia);
    add(grid_velocity_pass<Dim>());
    add_held({});
    if (setup.has_images()) add(unfold_images_pass<Dim>({}, false));
    add(velocity_gradient_pass<Dim>());
  };
  if constexpr (Dim == 2) {
    const bool is_acceleration = setup.has_virtual_stress() || (setup.motion && is_homogeneous(*setup.motion));
    if (body_force) add(body_force_pass<Dim>(setup.evaluation, is_acceleration));
    if (body_force && setup.frame && setup.frame->spin != 0) add(moving_frame_pass<Dim>(setup.evaluation));
    if (setup.uses_exact_solution()) add(inertia_pass<Dim>(method, setup.accounts));
  }
  if constexpr (Dim == 2) {
    if (remedies.largest_domain > 0) add(limit_domains_pass<Dim>(traits_of<Dim>(method.basis).moves_corners));
  }
  add(weights_pass<Dim>(method, !setup.seeds.half_edges.empty() || remedies.largest_domain > 0));
  if (method.is_affine() && method.affine == Affine::moment) add(first_affine_moment_pass<Dim>());
  const auto add_virtual_stress = [&] {
    if constexpr (Dim == 2) {
      if (setup.has_virtual_stress()) add(virtual_stress_pass(setup.traction->form));
    }
  };
  if (method.update != Update::usf) add_virtual_stress();
  if (method.update != Update::usf && !method.has_stages()) {
    add(particles_and_forces_to_grid_pass<Dim>(method, setup.hold_outside, body_force));
  } else {
    add(particles_to_grid_pass<Dim>(method, setup.hold_outside));
    if (method.update == Update::usf) {
      add_gradient_and_stress();
      add_stress();
      add_virtual_stress();
    }
    add(force_pass<Dim>(method, body_force));
  }
  const bool surface = Dim == 2 && setup.traction && !setup.has_virtual_stress();
  if constexpr (Dim == 2) {
    if (surface) add(traction_pass(method, *setup.traction, setup.accounts));
  }
  add_fold(method.update == Update::usf ? Folded::forces : Folded::both);
  if (remedies.small_mass > 0) add(small_mass_pass<Dim>());
  if (method.has_stages()) {
    add(kick_pass<Dim>(method));
  } else if (method.is_lumped()) {
    add(grid_update_pass<Dim>());
    add_held(reaction_of(method));
  } else {
    add(mass_matrix_pass<Dim>(method));
  }
  if (setup.has_images()) add(unfold_images_pass<Dim>(reaction_of(method), setup.accounts));
  if constexpr (Dim == 2) {
    if (surface && setup.accounts) add(traction_work_pass());
  }
  add(grid_to_particles_pass<Dim>(method, method.update == Update::usl, setup.accounts && body_force));
  if (method.is_affine() && affine_column(method) == Column::affine && !fits_with_corners<Dim>(method)) {
    add(affine_pass<Dim>(method));
  }
  if (method.update == Update::musl) {
    Pass<Dim> again = particles_to_grid_pass<Dim>(method, setup.hold_outside);
    again.name = "particles_to_grid_again";
    again.doc = "nodal momentum from the updated particle velocities (MUSL)";
    again.called_for_by = "method.update";
    add(std::move(again));
    add_gradient_and_stress();
  }
  add_accounts();
  if (method.update != Update::usf) add_stress();
  return step;
}

template <int Dim>
std::size_t bytes_of(Column column, const Setup<Dim>& setup) {
  const auto doubles = [](int components) { return static_cast<std::size_t>(components) * sizeof(double); };
  switch (column) {
    case Column::mass:
    case Column::volume:
    case Column::volume_ratio:
      return doubles(1);
    case Column::volume_scale:
      return doubles(2);
    case Column::reference_position:
    case Column::position:
    case Column::velocity:
    case Column::body_force:
      return doubles(Dim);
    case Column::deformation_gradient:
    case Column::velocity_gradient:
    case Column::affine:
      return doubles(tensor_components<Dim>);
    case Column::stress:
    case Column::excess_stress:
      return doubles(stress_components<Dim>);
    case Column::history:
      return history_bytes(setup.material->state_size());
    case Column::corners:
      return doubles(corner_components<Dim>);
    case Column::domain:
      return doubles(static_cast<int>(traits_of<Dim>(setup.method.basis).domain_components));
    case Column::weights:
      break;
  }
  return traits_of<Dim>(setup.method.basis).bytes;
}

template <int Dim>
std::vector<ColumnUse> columns_of(const std::vector<Pass<Dim>>& passes, const Setup<Dim>& setup) {
  std::vector<ColumnUse> columns;
  for (std::size_t k = 0; k < column_count; ++k) {
    ColumnUse use{static_cast<Column>(k), 0, {}};
    for (const auto& pass : passes) {
      const auto names = [&](const std::vector<Column>& list) {
        return std::find(list.begin(), list.end(), use.column) != list.end();
      };
      if (names(pass.reads) || names(pass.writes)) use.passes.push_back(pass.name);
    }
    if (use.passes.empty() && use.column != Column::reference_position) continue;
    use.bytes = bytes_of(use.column, setup);
    columns.push_back(std::move(use));
  }
  return columns;
}

template <int Dim>
std::size_t grid_bytes_per_node(const Setup<Dim>& setup) {
  const std::size_t inertia = GridField<Dim + 1>::stride, force = GridField<Dim>::stride;
  const std::size_t fields = inertia + force + GridField<2 * Dim>::stride;
  const std::size_t copies = tile_copies(setup.seeds.size(), setup.threads) * (inertia + force);
  const int across = mass_nodes_across<Dim>(setup.method);
  const std::size_t of_stencil = across == 0 ? 0 : MassStencil<Dim>::entries(across);
  const std::size_t of_matrix = setup.method.is_lumped() ? 0 : solver_fields(setup.method) * force + 1 + of_stencil;
  const std::size_t of_average = setup.remedies.averages_volume() ? 2 : 0;
  return (fields + copies + of_matrix + of_average + (setup.hold_outside ? 1 : 0)) * sizeof(double);
}

template std::vector<Pass<2>> compose(const Setup<2>&);
template std::vector<Pass<3>> compose(const Setup<3>&);
template std::vector<ColumnUse> columns_of(const std::vector<Pass<2>>&, const Setup<2>&);
template std::vector<ColumnUse> columns_of(const std::vector<Pass<3>>&, const Setup<3>&);
template std::size_t bytes_of(Column, const Setup<2>&);
template std::size_t bytes_of(Column, const Setup<3>&);
template std::size_t grid_bytes_per_node(const Setup<2>&);
template std::size_t grid_bytes_per_node(const Setup<3>&);

}  // namespace assay::mpm
