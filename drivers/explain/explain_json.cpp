// SPDX-License-Identifier: BSD-3-Clause
// `assay explain --json`.
#include <nlohmann/json.hpp>

#include "drivers/explain/composition.hpp"
#include "drivers/result/json_fields.hpp"
#include "mpm/step/stages.hpp"

namespace assay::drivers {

namespace {

using Json = nlohmann::ordered_json;

Json written(const mpm::Pass<2>& pass, const mpm::Setup<2>& setup) {
  return {{"name", pass.name},
          {"doc", pass.doc},
          {"reads", names_of(pass.reads)},
          {"writes", names_of(pass.writes)},
          {"grid_fields", pass.grid_fields},
          {"times_a_step", mpm::times_a_step(pass, setup.method)},
          {"bytes_moved_per_particle", bytes_moved(pass, setup)},
          {"called_for_by", pass.called_for_by},
          {"effects", pass.effects}};
}

Json written(const mpm::ColumnUse& use) {
  return {{"name", mpm::info(use.column).name},
          {"bytes_per_particle", use.bytes},
          {"passes", use.passes},
          {"effect", use.effect ? Json(*use.effect) : Json()}};
}

Json written(const mpm::GridFieldUse& use) {
  return {{"name", use.name}, {"doc", use.doc}, {"bytes_per_node", use.bytes}, {"effects", use.effects}};
}

Json written(const Sheet* sheet) {
  if (!sheet) return nullptr;
  return {{"points", sheet->points()}, {"error_tau", sheet->error_tau()}, {"error_dtau", sheet->error_dtau()}};
}

}  // namespace

std::string explanation_json(const Problem& problem, const ExactSolution* exact, const ScreenFigures& screen) {
  using Fields = JsonFields<Json>;
  const Composition c = composition_of(problem);
  Json json;
  for (const auto& pass : c.passes) json["passes"].push_back(written(pass, problem.setup));
  json["observers"] = Fields::of(observers_of(problem));
  for (const auto& use : c.columns) json["columns"].push_back(written(use));
  for (const auto& use : c.grid_fields) json["grid_fields"].push_back(written(use));
  json["bytes_per_particle"] = c.bytes_per_particle;
  json["bytes_per_node"] = c.bytes_per_node;
  json["work"] = Fields::of(c.work);
  json["effects"] = Fields::of(c.effects);
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
  json["sheet"] = written(exact && exact->response() ? (*exact->response())->sheet() : nullptr);
  json["screen"] = {{"verdict", screen.verdict}, {"smallest", *screen.smallest}, {"unjudged", screen.unjudged}};
  if (screen.largest_safe_amplitude) json["screen"]["largest_safe_amplitude"] = *screen.largest_safe_amplitude;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace assay::drivers
