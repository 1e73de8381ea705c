// SPDX-License-Identifier: BSD-3-Clause
// `assay explain --json`.
#include <nlohmann/json.hpp>

#include "drivers/explain/composition.hpp"
#include "mpm/step/stages.hpp"

namespace assay::drivers {

namespace {

using Json = nlohmann::ordered_json;

void add_passes(const Problem& problem, const Composition& c, Json& json) {
  const auto names = [](const std::vector<mpm::Column>& columns) {
    std::vector<std::string> list;
    for (const mpm::Column column : columns) list.emplace_back(mpm::info(column).name);
    return list;
  };
  for (const auto& pass : c.passes) {
    json["passes"].push_back({{"name", pass.name},
                              {"doc", pass.doc},
                              {"reads", names(pass.reads)},
                              {"writes", names(pass.writes)},
                              {"grid_fields", pass.grid_fields},
                              {"times_a_step", mpm::times_a_step(pass, problem.setup.method)},
                              {"bytes_moved_per_particle", bytes_moved(pass, problem.setup)},
                              {"called_for_by", pass.called_for_by},
                              {"effects", pass.effects}});
  }
}

void add_fields(const Composition& c, Json& json) {
  for (const auto& use : c.columns) {
    json["columns"].push_back({{"name", mpm::info(use.column).name},
                               {"bytes_per_particle", use.bytes},
                               {"passes", use.passes},
                               {"effect", use.effect ? Json(*use.effect) : Json()}});
  }
  for (const auto& use : c.grid_fields) {
    json["grid_fields"].push_back(
        {{"name", use.name}, {"doc", use.doc}, {"bytes_per_node", use.bytes}, {"effects", use.effects}});
  }
}

void add_effects(const Composition& c, Json& json) {
  for (const EffectPart& part : c.effects) {
    const EffectEntry& entry = entry_of(part.effect);
    json["effects"].push_back({{"name", entry.name},
                               {"doc", entry.doc},
                               {"key", part.key.empty() ? Json() : Json(part.key)},
                               {"there", part.is_there},
                               {"passes", part.passes},
                               {"columns", part.columns},
                               {"grid_fields", part.grid_fields},
                               {"asks_material", part.is_there && entry.asks_material},
                               {"bytes_per_particle", part.bytes_per_particle},
                               {"bytes_per_node", part.bytes_per_node}});
  }
}

}  // namespace

std::string explanation_json(const Problem& problem, const Composition& c, const Response* response,
                             const ScreenFigures& screen) {
  Json json;
  add_passes(problem, c, json);
  json["observers"] = Json::array();
  for (const Observer& o : observers_of(problem)) {
    json["observers"].push_back({{"name", o.name}, {"times", o.times}, {"called_for_by", o.called_for_by}});
  }
  add_fields(c, json);
  json["bytes_per_particle"] = c.bytes_per_particle;
  json["bytes_per_node"] = c.bytes_per_node;
  json["work"] = {{"column_bytes", c.work.column_bytes},
                  {"grid_bytes", c.work.grid_bytes},
                  {"material_updates", c.work.material_updates},
                  {"measured", false}};
  add_effects(c, json);
  json["nodes"] = problem.setup.grid.nodes();
  json["nodes_reached"] = c.nodes_reached;
  json["particles"] = problem.particles();
  json["stepped_particles"] = problem.setup.seeds.size();
  json["uses_exact_solution"] = problem.setup.uses_exact_solution();
  json["steps"] = problem.steps;
  json["dt"] = problem.dt;
  json["wave_speed"] = problem.wave_speed;
  if (problem.reference_wave_speed > 0) json["reference_wave_speed"] = problem.reference_wave_speed;
  if (problem.viscous_shortening > 1) json["viscous_shortening"] = problem.viscous_shortening;
  const Sheet* sheet = response ? response->sheet() : nullptr;
  if (sheet) {
    json["sheet"] = {
        {"points", sheet->points()}, {"error_tau", sheet->error_tau()}, {"error_dtau", sheet->error_dtau()}};
  } else {
    json["sheet"] = nullptr;
  }
  json["screen"] = {{"verdict", screen.verdict}, {"smallest", *screen.smallest}, {"unjudged", screen.unjudged}};
  if (screen.largest_safe_amplitude) json["screen"]["largest_safe_amplitude"] = *screen.largest_safe_amplitude;
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace assay::drivers
