// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/compose.hpp"

#include <algorithm>

#include "mpm/data/dimension.hpp"
#include "mpm/effects/passes_affine.hpp"
#include "mpm/effects/passes_body_force.hpp"
#include "mpm/effects/passes_images.hpp"
#include "mpm/effects/passes_inertia.hpp"
#include "mpm/effects/passes_massless.hpp"
#include "mpm/effects/passes_remedies.hpp"
#include "mpm/effects/passes_traction.hpp"
#include "mpm/kernels/affine.hpp"
#include "mpm/mass/mass_matrix.hpp"
#include "mpm/mass/passes_mass.hpp"
#include "mpm/material/material_batch.hpp"
#include "mpm/material/passes_particle.hpp"
#include "mpm/setup/with_basis.hpp"
#include "mpm/step/passes_grid.hpp"
#include "mpm/step/passes_to_grid.hpp"
#include "mpm/step/passes_to_particles.hpp"
#include "mpm/step/sweep.hpp"

namespace assay::mpm {

namespace {

template <int Dim>
Pass<Dim> stress_of(const Setup<Dim>& setup) {
  return stress_pass<Dim>(compiled(Effect::history) && setup.material->state_size() > 0);
}

/// Of MUSL: momentum once more.
template <int Dim>
Pass<Dim> again_of(Pass<Dim> pass) {
  pass.name = "particles_to_grid_again";
  pass.doc = "nodal momentum from the updated particle velocities (MUSL)";
  pass.called_for_by = "method.update";
  pass.effects = {Effect::remapped_velocity};
  return pass;
}

}  // namespace

/// The order of the passes in each update scheme. What this build leaves out (mpm/data/effect.hpp) is not even named.
template <int Dim>
std::vector<Pass<Dim>> compose(const Setup<Dim>& setup) {
  std::vector<Pass<Dim>> step;
  const auto add = [&](Pass<Dim> pass) { step.push_back(std::move(pass)); };
  const Method& method = setup.method;
  const auto add_held = [&](const Reaction& reaction) {
    if constexpr (compiled(Effect::outside_held)) {
      if (setup.hold_outside) add(hold_nodes_pass<Dim>(reaction));
    }
  };
  const auto add_fold = [&](Folded what) {
    if constexpr (compiled(Effect::images)) {
      if (setup.has_images()) add(fold_images_pass<Dim>(what, setup.accounts));
    }
  };
  const auto add_unfold = [&](const Reaction& reaction, bool accounts) {
    if constexpr (compiled(Effect::images)) {
      if (setup.has_images()) add(unfold_images_pass<Dim>(reaction, accounts));
    }
  };
  const bool massless = has_massless_nodes(setup);
  const auto add_fold_massless = [&](Folded what) {
    if (massless) add(fold_massless_pass<Dim>(what));
  };
  const auto add_unfold_massless = [&] {
    if (massless) add(unfold_massless_pass<Dim>());
  };
  const bool body_force = Dim == 2 && setup.body_force;  // lives in the plane
  const Remedies& remedies = setup.remedies;
  const auto add_stress = [&] {
    if constexpr (compiled(Effect::anti_locking)) {
      if (remedies.averages_volume()) {
        add(step_volumes_pass<Dim>());
        add(average_volume_pass<Dim>(method, remedies.anti_locking));
      }
    }
    add(stress_of(setup));
    if constexpr (compiled(Effect::artificial_viscosity)) {
      if (remedies.has_viscosity()) add(viscosity_pass<Dim>(method));
    }
  };
  const auto add_accounts = [&] {
    if constexpr (compiled(Effect::energy_account)) {
      if (setup.accounts) add(accounts_pass<Dim>(method, body_force));
    }
  };
  const auto add_gradient_and_stress = [&] {
    add_fold(Folded::inertia);
    add_fold_massless(Folded::inertia);
    const bool again = method.update == Update::musl;
    const auto add_of_update = [&](Pass<Dim> pass) {
      pass.effects = {again ? Effect::remapped_velocity : Effect::stress_first};
      add(std::move(pass));
    };
    add_of_update(grid_velocity_pass<Dim>());
    add_held({});
    add_unfold_massless();
    add_unfold({}, false);
    add_of_update(velocity_gradient_pass<Dim>());
  };
  if constexpr (Dim == 2) {
    if (body_force) add(body_force_pass<Dim>(setup.evaluation, setup.force_is_acceleration()));
    if constexpr (compiled(Effect::moving_frame)) {
      if (body_force && setup.frame && setup.frame->spin != 0) add(moving_frame_pass<Dim>(setup.evaluation));
    }
    if constexpr (compiled(Effect::inertia_to_particles) || compiled(Effect::virtual_stress)) {
      const bool given = setup.inertia == Inertia::particles;
      if (body_force && setup.uses_exact_solution()) add(inertia_pass<Dim>(method, given, setup.accounts));
    }
  }
  if constexpr (Dim == 2 && compiled(Effect::largest_domain)) {
    if (remedies.largest_domain > 0) add(limit_domains_pass<Dim>(traits_of<Dim>(method.basis).moves_corners));
  }
  add(weights_pass<Dim>(method, !setup.seeds.half_edges.empty() || remedies.largest_domain > 0));
  if constexpr (compiled(Effect::affine_velocity)) {
    if (method.is_affine() && method.affine == Affine::moment) add(first_affine_moment_pass<Dim>());
  }
  const auto add_virtual_stress = [&] {
    if constexpr (Dim == 2 && compiled(Effect::virtual_stress)) {
      if (setup.has_virtual_stress()) add(virtual_stress_pass(setup.traction->form));
    }
  };
  if (method.update != Update::usf) add_virtual_stress();
  if (method.update != Update::usf && !method.has_stages()) {
    add(particles_and_forces_to_grid_pass<Dim>(method, setup.hold_outside, body_force));
  } else {
    add(particles_to_grid_pass<Dim>(method, setup.hold_outside));
    if constexpr (compiled(Effect::stress_first)) {
      if (method.update == Update::usf) {
        add_gradient_and_stress();
        add_stress();
        add_virtual_stress();
      }
    }
    if constexpr (compiled(Effect::stress_first) || compiled(Effect::force_stages)) {
      Pass<Dim> forces = force_pass<Dim>(method, body_force);
      forces.effects = {method.has_stages() ? Effect::force_stages : Effect::stress_first};
      add(std::move(forces));
    }
  }
  const bool surface = Dim == 2 && setup.traction && !setup.has_virtual_stress();
  constexpr bool loads = Dim == 2 && (compiled(Effect::edge_traction) || compiled(Effect::particle_traction) ||
                                      compiled(Effect::undeformed_traction));
  if constexpr (loads) {
    if (surface) add(traction_pass(method, *setup.traction, setup.accounts));
  }
  const Folded of_step = method.update == Update::usf ? Folded::forces : Folded::both;
  add_fold(of_step);
  add_fold_massless(of_step);
  if constexpr (compiled(Effect::small_mass)) {
    if (remedies.small_mass > 0) add(small_mass_pass<Dim>());
  }
  if (method.is_lumped()) {
    add(grid_update_pass<Dim>());
    add_held(reaction_of(method));
  } else if constexpr (compiled(Effect::mass_matrix)) {
    add(method.has_stages() ? kick_pass<Dim>(method) : mass_matrix_pass<Dim>(method));
  }
  add_unfold_massless();
  add_unfold(reaction_of(method), setup.accounts);
  if constexpr (loads && compiled(Effect::energy_account)) {
    if (surface && setup.accounts) add(traction_work_pass(setup.traction->algorithm));
  }
  add(grid_to_particles_pass<Dim>(method, method.update == Update::usl, setup.accounts && body_force));
  if constexpr (compiled(Effect::affine_velocity)) {
    if (method.is_affine() && affine_column(method) == Column::affine && !fits_with_corners<Dim>(method)) {
      add(affine_pass<Dim>(method));
    }
  }
  if constexpr (compiled(Effect::remapped_velocity)) {
    if (method.update == Update::musl) {
      add(again_of(particles_to_grid_pass<Dim>(method, setup.hold_outside)));
      add_gradient_and_stress();
    }
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
      return doubles(1);
    case Column::step_volumes:
      return doubles(2);
    case Column::volume_scale:
      return doubles(setup.method.is_total() ? 2 : 1);
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
    ColumnUse use{static_cast<Column>(k), 0, {}, effect_of(static_cast<Column>(k))};
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
std::vector<GridFieldUse> grid_fields_of(const Setup<Dim>& setup) {
  constexpr std::size_t number = sizeof(double);
  constexpr std::size_t inertia = GridField<Dim + 1>::stride * number, force = GridField<Dim>::stride * number;
  std::vector<GridFieldUse> fields{
      {"inertia", "mass and momentum", inertia, {"mass", "momentum"}, {}},
      {"force", "forces of stress, body and surface", force, {"force"}, {}},
      {"motion", "velocity and acceleration", GridField<2 * Dim>::stride * number, {"velocity", "acceleration"}, {}}};
  const auto add = [&](const char* name, const char* doc, std::size_t bytes, std::vector<Effect> effects) {
    if (bytes > 0) fields.push_back({name, doc, bytes, {name}, std::move(effects)});
  };
  add("tile_copies", "where a thread adds up inertia and force",
      tile_copies(setup.seeds.size(), setup.threads) * (inertia + force), {});
  if (setup.hold_outside) add("held_mass", "of the particles that never move", number, {Effect::outside_held});
  if (setup.remedies.averages_volume()) {
    add("cell_volume", "reference and current volume, a cell or node", 2 * number, {Effect::anti_locking});
  }
  if constexpr (compiled(Effect::mass_matrix)) {
    if (setup.method.is_lumped()) return fields;
    const auto effects = effects_of_matrix(setup.method);
    const int across = mass_nodes_across<Dim>(setup.method);
    add("solver", "vectors of the mass matrix's inversion", solver_fields(setup.method) * force, effects);
    add("inverse_mass", "1 / row sum of the mass matrix", number, effects);
    add("mass_stencil", "the mass matrix, made once", across == 0 ? 0 : MassStencil<Dim>::entries(across) * number,
        effects);
  }
  return fields;
}

template <int Dim>
std::size_t grid_bytes_per_node(const Setup<Dim>& setup) {
  std::size_t bytes = 0;
  for (const GridFieldUse& field : grid_fields_of(setup)) bytes += field.bytes;
  return bytes;
}

template std::vector<Pass<ASSAY_DIMENSION>> compose(const Setup<ASSAY_DIMENSION>&);
template std::vector<ColumnUse> columns_of(const std::vector<Pass<ASSAY_DIMENSION>>&, const Setup<ASSAY_DIMENSION>&);
template std::size_t bytes_of(Column, const Setup<ASSAY_DIMENSION>&);
template std::vector<GridFieldUse> grid_fields_of(const Setup<ASSAY_DIMENSION>&);
template std::size_t grid_bytes_per_node(const Setup<ASSAY_DIMENSION>&);

}  // namespace assay::mpm
