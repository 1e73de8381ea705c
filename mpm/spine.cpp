// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/spine.hpp"

#include "mpm/data/dimension.hpp"
#include "mpm/material/passes_particle.hpp"
#include "mpm/setup/with_basis.hpp"
#include "mpm/step/passes_grid.hpp"
#include "mpm/step/passes_massless.hpp"
#include "mpm/step/passes_to_grid.hpp"
#include "mpm/step/passes_to_particles.hpp"
#include "mpm/step/sweep.hpp"

namespace assay::mpm {

/// Mass, momentum and forces reach the grid at once where the stress is that of the step before.
template <int Dim>
std::vector<Pass<Dim>> spine_passes(const Setup<Dim>& setup) {
  const Method& method = setup.method;
  const bool body_force = Dim == 2 && setup.body_force;  // lives in the plane
  const bool last = method.update == Update::usl, at_once = method.update != Update::usf && !method.has_stages();
  std::vector<Pass<Dim>> passes{
      weights_pass<Dim>(method, !setup.seeds.half_edges.empty() || setup.remedies.largest_domain > 0),
      at_once ? particles_and_forces_to_grid_pass<Dim>(method, body_force) : particles_to_grid_pass<Dim>(method),
      grid_update_pass<Dim>(), grid_to_particles_pass<Dim>(method, last, setup.accounts && body_force),
      stress_pass<Dim>(setup.material->state_size() > 0)};
  passes.back().slot = {stress_phase(method)};
  if (!has_massless_nodes(setup)) return passes;
  for (const GridPhase& grid : grid_phases(method)) {
    passes.push_back(fold_massless_pass<Dim>(grid.phase, grid.folded));
    passes.push_back(unfold_massless_pass<Dim>(grid.phase));
  }
  return passes;
}

template <int Dim>
std::vector<ColumnRecord<Dim>> spine_columns() {
  const auto number = [](const Setup<Dim>&) { return doubles(1); };
  const auto vector = [](const Setup<Dim>&) { return doubles(Dim); };
  const auto tensor = [](const Setup<Dim>&) { return doubles(tensor_components<Dim>); };
  return {
      {Column::reference_position, "reference_position", "m", "X", vector},
      {Column::position, "position", "m", "x", vector},
      {Column::velocity, "velocity", "m/s", "v", vector},
      {Column::mass, "mass", "kg", "constant", number},
      {Column::volume, "volume", "m^3", "reference volume, per unit thickness in two dimensions", number},
      {Column::deformation_gradient, "deformation_gradient", "1", "F, in-plane components", tensor, true},
      {Column::stress, "stress", "Pa", "Cauchy stress, in-plane components and 33",
       [](const Setup<Dim>&) { return doubles(stress_components<Dim>); }, true},
      {Column::velocity_gradient, "velocity_gradient", "1/s", "L of the step; dF/dt in the total formulation", tensor,
       true},
      {Column::weights, "weights", "1", "nodes, weights and gradients of the step",
       [](const Setup<Dim>& s) { return traits_of<Dim>(s.method.basis).bytes; }},
  };
}

template <int Dim>
std::vector<GridFieldUse> spine_fields(const Setup<Dim>& setup) {
  constexpr std::size_t inertia = doubles(GridField<Dim + 1>::stride), force = doubles(GridField<Dim>::stride);
  return {{"inertia", "mass and momentum", inertia, {"mass", "momentum"}},
          {"force", "forces of stress, body and surface", force},
          {"motion", "velocity and acceleration", doubles(GridField<2 * Dim>::stride), {"velocity", "acceleration"}},
          {"tile_copies", "where a thread adds up inertia and force",
           tile_copies(setup.seeds.size(), setup.threads) * (inertia + force)}};
}

template std::vector<Pass<ASSAY_DIMENSION>> spine_passes(const Setup<ASSAY_DIMENSION>&);
template std::vector<ColumnRecord<ASSAY_DIMENSION>> spine_columns();
template std::vector<GridFieldUse> spine_fields(const Setup<ASSAY_DIMENSION>&);

}  // namespace assay::mpm
