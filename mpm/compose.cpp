// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/compose.hpp"
#include "mpm/material/material_batch.hpp"
#include "mpm/step/passes.hpp"
#include "mpm/step/run_kernels.hpp"

#include <algorithm>

namespace assay::mpm {

namespace {

// The spine: what every step has, whatever a scene calls for.

/// Mass, momentum and forces reach the grid at once where the stress is that of the step before.
template <int Dim>
std::vector<Pass<Dim>> spine_passes(const Setup<Dim>& setup) {
  const Method& method = setup.method;
  const bool body_force = setup.body_force;
  const bool last = method.update == Update::usl, at_once = method.update != Update::usf && !method.has_stages();
  std::vector<Pass<Dim>> passes{
      weights_pass<Dim>(method, !setup.seeds.half_edges.empty() || option<LargestDomain>(setup).cells > 0),
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
      {Column::velocity, "velocity", "m/s", "v", vector, in_snapshots},
      {Column::mass, "mass", "kg", "constant", number},
      {Column::volume, "volume", "m^3", "reference volume, per unit thickness in two dimensions", number, in_snapshots},
      {Column::deformation_gradient, "deformation_gradient", "1", Dim == 2 ? "F, in-plane components" : "F", tensor,
       of_stress | in_snapshots},
      {Column::stress, "stress", "Pa",
       Dim == 2 ? "Cauchy stress, in-plane components and 33" : "Cauchy stress, six components",
       [](const Setup<Dim>&) { return doubles(stress_components<Dim>); }, of_stress | in_snapshots},
      {Column::velocity_gradient, "velocity_gradient", "1/s", "L of the step; dF/dt in the total formulation", tensor,
       of_stress},
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

/// Of the main parts of phases the pass takes the place of the one that is there, and is of that one's effects, too.
template <int Dim>
void add_pass(std::vector<Pass<Dim>>& step, Pass<Dim> pass) {
  const auto same = std::find_if(step.begin(), step.end(), [&](const Pass<Dim>& other) {
    return pass.slot.part == Part::main && other.slot == pass.slot;
  });
  if (same == step.end()) return step.push_back(std::move(pass));
  pass.effects.insert(pass.effects.begin(), same->effects.begin(), same->effects.end());
  *same = std::move(pass);
}

}  // namespace

// cmake/file_list.cmake writes a line for each file of mpm/effects.
#define ASSAY_EFFECT(name) \
  template <int Dim>       \
  EffectRecord<Dim> name##_effect();
#include "effect_list.inc"
#undef ASSAY_EFFECT

template <int Dim>
const std::vector<EffectRecord<Dim>>& effects() {
  static const std::vector<EffectRecord<Dim>> list = [] {
    std::vector<EffectRecord<Dim>> all;
    const auto add = [&](const char* name, EffectRecord<Dim> record) {
      record.name = name;
      for (ColumnRecord<Dim>& column : record.columns) column.effect = name;
      all.push_back(std::move(record));
    };
#define ASSAY_EFFECT(name) add(#name, name##_effect<Dim>());
#include "effect_list.inc"
#undef ASSAY_EFFECT
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.place < b.place; });
    return all;
  }();
  return list;
}

template <int Dim>
std::optional<Contradiction> contradiction(const Method& method, const EffectOptions& options) {
  Setup<Dim> setup;
  setup.method = method;
  setup.options = options;
  for (const EffectRecord<Dim>& effect : effects<Dim>()) {
    if (!effect.refusal || !effect.called_for(setup)) continue;
    if (std::string reason = effect.refusal(method, options); !reason.empty())
      return Contradiction{effect.key, std::move(reason)};
  }
  return std::nullopt;
}

template <int Dim>
const ColumnRecord<Dim>& record_of(Column column) {
  static const std::vector<ColumnRecord<Dim>> list = [] {
    std::vector<ColumnRecord<Dim>> all = spine_columns<Dim>();
    for (const auto& effect : effects<Dim>()) all.insert(all.end(), effect.columns.begin(), effect.columns.end());
    std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.column < b.column; });
    return all;
  }();
  return list.at(static_cast<std::size_t>(column));
}

template <int Dim>
std::vector<Pass<Dim>> compose(const Setup<Dim>& setup) {
  std::vector<Pass<Dim>> step = spine_passes(setup);
  for (const EffectRecord<Dim>& effect : effects<Dim>()) {
    if (!effect.passes || !effect.called_for(setup)) continue;
    for (Pass<Dim>& pass : effect.passes(setup)) {
      pass.effects.insert(pass.effects.begin(), effect.name);
      if (pass.called_for_by.empty()) pass.called_for_by = effect.key;
      add_pass(step, std::move(pass));
    }
  }
  std::stable_sort(step.begin(), step.end(), [](const auto& a, const auto& b) { return a.slot < b.slot; });
  return step;
}

template <int Dim>
std::vector<ColumnUse> columns_of(const std::vector<Pass<Dim>>& passes, const Setup<Dim>& setup) {
  std::vector<ColumnUse> columns;
  for (std::size_t k = 0; k < column_count; ++k) {
    ColumnUse use{static_cast<Column>(k), 0, {}, {}};
    for (const auto& pass : passes) {
      const auto names = [&](const std::vector<Column>& list) {
        return std::find(list.begin(), list.end(), use.column) != list.end();
      };
      if (names(pass.reads) || names(pass.writes)) use.passes.push_back(pass.name);
    }
    if (use.passes.empty() && use.column != Column::reference_position) continue;
    const ColumnRecord<Dim>& record = record_of<Dim>(use.column);
    use.bytes = record.bytes(setup);
    if (!record.effect.empty()) use.effect = record.effect;
    columns.push_back(std::move(use));
  }
  return columns;
}

template <int Dim>
std::vector<GridFieldUse> grid_fields_of(const Setup<Dim>& setup) {
  std::vector<GridFieldUse> fields = spine_fields(setup);
  for (const EffectRecord<Dim>& effect : effects<Dim>()) {
    if (!effect.grid_fields || !effect.called_for(setup)) continue;
    for (GridFieldUse& field : effect.grid_fields(setup)) {
      auto at = std::find_if(fields.begin(), fields.end(), [&](const auto& other) { return other.name == field.name; });
      if (at == fields.end()) at = fields.insert(at, std::move(field));
      at->effects.push_back(effect.name);
    }
  }
  std::stable_partition(fields.begin(), fields.end(), [](const GridFieldUse& field) { return !field.is_last; });
  std::erase_if(fields, [](const GridFieldUse& field) { return field.bytes == 0; });
  for (GridFieldUse& field : fields) {
    if (field.holds.empty()) field.holds = {field.name};
  }
  return fields;
}

template <int Dim>
std::size_t grid_bytes_per_node(const Setup<Dim>& setup) {
  std::size_t bytes = 0;
  for (const GridFieldUse& field : grid_fields_of(setup)) bytes += field.bytes;
  return bytes;
}

template const std::vector<EffectRecord<ASSAY_DIMENSION>>& effects();
template std::optional<Contradiction> contradiction<ASSAY_DIMENSION>(const Method&, const EffectOptions&);
template const ColumnRecord<ASSAY_DIMENSION>& record_of(Column);
template std::vector<Pass<ASSAY_DIMENSION>> compose(const Setup<ASSAY_DIMENSION>&);
template std::vector<ColumnUse> columns_of(const std::vector<Pass<ASSAY_DIMENSION>>&, const Setup<ASSAY_DIMENSION>&);
template std::vector<GridFieldUse> grid_fields_of(const Setup<ASSAY_DIMENSION>&);
template std::size_t grid_bytes_per_node(const Setup<ASSAY_DIMENSION>&);

}  // namespace assay::mpm
