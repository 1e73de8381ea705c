// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/explain/effects.hpp"

#include <stdexcept>

#include "adapters/worker/remote_table.hpp"

namespace assay::drivers {

namespace {

EffectEntry entry_of_step(const mpm::EffectRecord<2>& record) {
  EffectEntry entry{record.name, record.doc, record.key, record.around, {}, record.asks_material};
  entry.called_for = [&record](const Problem& problem) { return record.called_for(problem.setup); };
  if (record.called_by) {
    entry.called_by = [&record](const Problem& problem) { return record.called_by(problem.setup); };
  }
  return entry;
}

#define IF(expression) [](const Problem& p) -> bool { return expression; }

// clang-format off
std::vector<EffectEntry> of_runs() {
  return {
      {"time_control", "steps from the present fastest wave and fastest particle", "time.control",
       "calls of the material at some or all particles, between steps",
       IF(p.scene.time.control == TimeChoice::Control::current)},
      {"screening", "whether the exact motion is a stable solution", "force.response",
       "updates of the material along the path, before the run", IF(p.compared)},
      {"error_sampling", "errors against the exact motion", "force.response",
       "the exact fields at the particles, between steps", IF(p.compared)},
      {"shadow", "histories of the response, stepped during the run", "force.response", "histories",
       IF(p.compared && p.scene.force.response == ForceChoice::Response::shadow && ring_of(p.scene.motion)), true},
      {"isolation", "the material in processes of its own", "material.isolation",
       "workers, and memory shared with them", IF(!adapters::start_of(&p.material->table()).task.empty())},
      {"snapshots", "particles as VTU files", "output.particles", "files, between steps",
       IF(p.scene.output.writes_particles())},
      {"pictures", "particles and errors as PNG files", "output.pictures", "two frames of the particles",
       IF(p.scene.output.pictures && p.compared)},
      {"report", "report.html", "output.report", "a page, after the run", IF(p.scene.output.report)},
      {"traction_table", "the algorithms of tractions side by side", "output.tractions",
       "runs of the scene on three grids", IF(p.scene.output.tractions)},
  };
}
// clang-format on
#undef IF

}  // namespace

std::span<const EffectEntry> effects() {
  static const std::vector<EffectEntry> list = [] {
    std::vector<EffectEntry> all;
    for (const auto& record : mpm::effects<2>()) all.push_back(entry_of_step(record));
    for (EffectEntry& entry : of_runs()) all.push_back(std::move(entry));
    return all;
  }();
  return list;
}

const EffectEntry& entry_of(const std::string& effect) {
  for (const EffectEntry& entry : effects()) {
    if (entry.name == effect) return entry;
  }
  throw std::out_of_range("no effect " + effect);
}

std::vector<std::string> effects_of(const Problem& problem) {
  std::vector<std::string> found;
  for (const EffectEntry& entry : effects()) {
    if (entry.called_for(problem)) found.push_back(entry.name);
  }
  return found;
}

}  // namespace assay::drivers
