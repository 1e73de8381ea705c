// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/explain/composition.hpp"

#include <algorithm>
#include <stdexcept>

#include "adapters/worker/remote_table.hpp"
#include "drivers/simulation/simulate.hpp"
#include "harness/motion/kinds/vortex3d.hpp"
#include "mpm/seeding/lattice.hpp"
#include "mpm/step/stages.hpp"

namespace assay::drivers {

namespace {

template <int Dim>
EffectEntryIn<Dim> entry_of_step(const mpm::EffectRecord<Dim>& record) {
  EffectEntryIn<Dim> entry{{record.name, record.doc, record.key, record.around, record.asks_material}, {}, {}};
  entry.called_for = [&record](const ProblemIn<Dim>& problem) { return record.called_for(problem.setup); };
  if (record.called_by)
    entry.called_by = [&record](const ProblemIn<Dim>& problem) { return record.called_by(problem.setup); };
  return entry;
}

/// An effect of a run, for which the scene calls alone.
struct RunEffect {
  EffectEntry entry;
  bool (*called_for)(const PosedScene&);
};

#define IF(expression) [](const PosedScene& p) -> bool { return expression; }

// clang-format off
std::vector<RunEffect> of_runs() {
  return {
      {{"time_control", "steps from the present fastest wave and fastest particle", "time.control",
        "calls of the material at some or all particles, between steps"},
       IF(p.scene.time.control == TimeChoice::Control::current)},
      {{"screening", "whether the exact motion is a stable solution", "force.response",
        "updates of the material along the path, before the run"}, IF(p.compared)},
      {{"error_sampling", "errors against the exact motion", "force.response",
        "the exact fields at the particles, between steps"}, IF(p.compared)},
      {{"shadow", "histories of the response, stepped during the run", "force.response", "histories", true},
       IF(p.compared && p.scene.force.response == ForceChoice::Response::shadow &&
          (ring_of(p.scene.motion) || p.scene.motion.as<Vortex3d>()))},
      {{"isolation", "the material in processes of its own", "material.isolation",
        "workers, and memory shared with them"}, IF(!adapters::start_of(&p.material->table()).task.empty())},
      {{"snapshots", "particles as VTU files", "output.particles", "files, between steps"},
       IF(p.scene.output.writes_particles())},
      {{"pictures", "particles and errors as PNG files", "output.pictures", "two frames of the particles"},
       IF(p.scene.output.pictures && p.compared)},
      {{"report", "report.html", "output.report", "a page, after the run"}, IF(p.scene.output.report)},
      {{"traction_table", "the algorithms of tractions side by side", "output.tractions",
        "runs of the scene on three grids"}, IF(p.scene.output.tractions)},
  };
}
// clang-format on
#undef IF

template <int Dim>
EffectPart part_of(const EffectEntryIn<Dim>& entry, const ProblemIn<Dim>& problem, const Composition& c) {
  EffectPart part{entry.name, entry.called_for(problem), entry.key, {}, {}, {}};
  if (part.is_there) part.key = entry.key_of(problem);
  for (const auto& pass : c.passes) {
    if (is_one_of(entry.name, pass.effects)) part.passes.push_back(pass.name);
  }
  for (const mpm::ColumnUse& use : c.columns) {
    if (use.effect != entry.name) continue;
    part.columns.emplace_back(mpm::info(use.column).name);
    part.bytes_per_particle += use.bytes;
  }
  for (const mpm::GridFieldUse& use : c.grid_fields) {
    if (!is_one_of(entry.name, use.effects)) continue;
    part.grid_fields.push_back(use.name);
    part.bytes_per_node += use.bytes;
  }
  return part;
}

template <int Dim>
StepWork work_of(const ProblemIn<Dim>& problem, const Composition& c) {
  const mpm::Setup<Dim>& setup = problem.setup;
  const auto particles = static_cast<double>(setup.seeds.size()), nodes = static_cast<double>(c.nodes_reached);
  StepWork work;
  for (const auto& pass : c.passes) {
    if (pass.once) continue;
    const std::size_t times = mpm::times_a_step(pass, setup.method);
    work.column_bytes += particles * static_cast<double>(times * bytes_moved(pass, setup));
    for (const mpm::GridFieldUse& use : c.grid_fields) {
      const auto is_its_own = [&pass](const std::string& name) { return is_one_of(name, pass.grid_fields); };
      if (std::ranges::any_of(use.holds, is_its_own)) work.grid_bytes += nodes * static_cast<double>(times * use.bytes);
    }
    if (pass.updates_material) work.material_updates += static_cast<std::int64_t>(times * setup.seeds.size());
  }
  return work;
}

}  // namespace

template <int Dim>
std::span<const EffectEntryIn<Dim>> effects() {
  static const std::vector<EffectEntryIn<Dim>> list = [] {
    std::vector<EffectEntryIn<Dim>> all;
    for (const auto& record : mpm::effects<Dim>()) all.push_back(entry_of_step(record));
    for (const RunEffect& effect : of_runs()) all.push_back({effect.entry, effect.called_for, {}});
    return all;
  }();
  return list;
}

template <int Dim>
const EffectEntryIn<Dim>& entry_of(const std::string& effect) {
  for (const EffectEntryIn<Dim>& entry : effects<Dim>()) {
    if (entry.name == effect) return entry;
  }
  throw std::out_of_range("no effect " + effect);
}

template <int Dim>
std::size_t bytes_moved(const mpm::PassInfo& pass, const mpm::Setup<Dim>& setup) {
  std::size_t bytes = 0;
  for (const auto* list : {&pass.reads, &pass.writes}) {
    for (const mpm::Column column : *list) bytes += mpm::bytes_of(column, setup);
  }
  return bytes;
}

template <int Dim>
Composition composition_of(const ProblemIn<Dim>& problem) {
  Composition c;
  const auto passes = mpm::compose(problem.setup);
  c.passes.assign(passes.begin(), passes.end());
  c.columns = mpm::columns_of(passes, problem.setup);
  c.grid_fields = mpm::grid_fields_of(problem.setup);
  for (const auto& use : c.columns) c.bytes_per_particle += use.bytes;
  for (const auto& use : c.grid_fields) c.bytes_per_node += use.bytes;
  c.nodes_reached = mpm::nodes_reached(problem.setup);
  c.work = work_of(problem, c);
  for (const auto& entry : effects<Dim>()) c.effects.push_back(part_of(entry, problem, c));
  return c;
}

std::vector<std::string> names_of(const std::vector<mpm::Column>& columns) {
  return mapped(columns, [](mpm::Column column) { return std::string(mpm::info(column).name); });
}

std::vector<Observer> observers_of(const PosedScene& problem) {
  const Observations due = observations_of(problem);
  std::vector<Observer> list;
  if (!due.samples.empty()) list.push_back({"error_sampling", due.samples.size(), "output.errors"});
  if (!due.shots.empty()) {
    list.push_back({"snapshots", due.shots.size(),
                    problem.scene.output.writes_particles() ? "output.particles" : "output.pictures"});
  }
  return list;
}

template std::span<const EffectEntryIn<2>> effects<2>();
template std::span<const EffectEntryIn<3>> effects<3>();
template const EffectEntryIn<2>& entry_of<2>(const std::string&);
template std::size_t bytes_moved(const mpm::PassInfo&, const mpm::Setup<2>&);
template std::size_t bytes_moved(const mpm::PassInfo&, const mpm::Setup<3>&);
template Composition composition_of(const ProblemIn<2>&);
template Composition composition_of(const ProblemIn<3>&);

}  // namespace assay::drivers
