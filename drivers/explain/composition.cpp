// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/explain/composition.hpp"

#include <algorithm>

#include "drivers/simulation/simulate.hpp"
#include "mpm/seeding/nodes_reached.hpp"
#include "mpm/step/stages.hpp"

namespace assay::drivers {

namespace {

bool contains(const std::vector<std::string>& list, const std::string& name) {
  return std::ranges::count(list, name) > 0;
}

EffectPart part_of(const EffectEntry& entry, const Problem& problem, const Composition& c) {
  EffectPart part{entry.name, entry.called_for(problem), entry.key, {}, {}, {}};
  if (part.is_there) part.key = entry.key_of(problem);
  for (const auto& pass : c.passes) {
    if (contains(pass.effects, entry.name)) part.passes.push_back(pass.name);
  }
  for (const mpm::ColumnUse& use : c.columns) {
    if (use.effect != entry.name) continue;
    part.columns.emplace_back(mpm::info(use.column).name);
    part.bytes_per_particle += use.bytes;
  }
  for (const mpm::GridFieldUse& use : c.grid_fields) {
    if (!contains(use.effects, entry.name)) continue;
    part.grid_fields.push_back(use.name);
    part.bytes_per_node += use.bytes;
  }
  return part;
}

StepWork work_of(const Problem& problem, const Composition& c) {
  const mpm::Setup<2>& setup = problem.setup;
  const auto particles = static_cast<double>(setup.seeds.size()), nodes = static_cast<double>(c.nodes_reached);
  StepWork work;
  for (const auto& pass : c.passes) {
    if (pass.once) continue;
    const std::size_t times = mpm::times_a_step(pass, setup.method);
    work.column_bytes += particles * static_cast<double>(times * bytes_moved(pass, setup));
    for (const mpm::GridFieldUse& use : c.grid_fields) {
      const auto is_its_own = [&pass](const std::string& name) { return contains(pass.grid_fields, name); };
      if (std::ranges::any_of(use.holds, is_its_own)) work.grid_bytes += nodes * static_cast<double>(times * use.bytes);
    }
    if (pass.updates_material) work.material_updates += static_cast<std::int64_t>(times * setup.seeds.size());
  }
  return work;
}

}  // namespace

std::size_t bytes_moved(const mpm::PassInfo& pass, const mpm::Setup<2>& setup) {
  std::size_t bytes = 0;
  for (const auto* list : {&pass.reads, &pass.writes}) {
    for (const mpm::Column column : *list) bytes += mpm::bytes_of(column, setup);
  }
  return bytes;
}

Composition composition_of(const Problem& problem) {
  Composition c;
  c.passes = mpm::compose(problem.setup);
  c.columns = mpm::columns_of(c.passes, problem.setup);
  c.grid_fields = mpm::grid_fields_of(problem.setup);
  for (const auto& use : c.columns) c.bytes_per_particle += use.bytes;
  for (const auto& use : c.grid_fields) c.bytes_per_node += use.bytes;
  c.nodes_reached = mpm::nodes_reached(problem.setup);
  c.work = work_of(problem, c);
  for (const EffectEntry& entry : effects()) c.effects.push_back(part_of(entry, problem, c));
  return c;
}

std::vector<std::string> names_of(const std::vector<mpm::Column>& columns) {
  std::vector<std::string> names;
  for (const mpm::Column column : columns) names.emplace_back(mpm::info(column).name);
  return names;
}

std::vector<Observer> observers_of(const Problem& problem) {
  const Observations due = observations_of(problem);
  std::vector<Observer> list;
  if (!due.samples.empty()) list.push_back({"error_sampling", due.samples.size(), "output.errors"});
  if (!due.shots.empty()) {
    list.push_back({"snapshots", due.shots.size(),
                    problem.scene.output.writes_particles() ? "output.particles" : "output.pictures"});
  }
  return list;
}

}  // namespace assay::drivers
