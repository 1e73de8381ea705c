// SPDX-License-Identifier: BSD-3-Clause
// What `assay explain` prints, as text and as JSON.
#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "drivers/explain/composition.hpp"
#include "drivers/result/json_fields.hpp"
#include "drivers/simulation/response_source.hpp"
#include "drivers/simulation/warnings.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/wrapped_text.hpp"
#include "mpm/step/stages.hpp"

namespace assay::drivers {

namespace {

std::string bytes_text(double bytes) { return rounded_text(bytes / (1024.0 * 1024), 3) + " MiB"; }

/// "pass ...; column ..., 16 bytes a particle; grid field ..., 8 bytes a node".
std::string brought_text(const EffectPart& part) {
  const EffectEntry& entry = entry_of(part.effect);
  std::string text;
  const auto add = [&](bool is_there, const std::string& what) {
    if (is_there) text += (text.empty() ? "" : "; ") + what;
  };
  add(!part.passes.empty(), "pass " + joined(part.passes));
  add(!part.columns.empty(),
      fmt::format("column {}, {} bytes a particle", joined(part.columns), part.bytes_per_particle));
  add(!part.grid_fields.empty(),
      fmt::format("grid field {}, {} bytes a node", joined(part.grid_fields), part.bytes_per_node));
  add(!entry.around.empty(), entry.around);
  add(entry.asks_material, "calls of the material beside the particles' stress");
  return text;
}

template <int Dim>
std::string passes_text(const ProblemIn<Dim>& problem, const Composition& c) {
  std::string text = "passes of a step\n";
  const std::string indent(22, ' ');
  for (const auto& pass : c.passes) {
    text += wrapped(pass.doc, fmt::format("  {:19} ", pass.name), indent);
    const auto add = [&](const std::string& does, const std::vector<std::string>& names) {
      if (!names.empty()) text += wrapped(does + joined(names), indent + "  ", indent + "    ");
    };
    add("reads ", names_of(pass.reads));
    add("writes ", names_of(pass.writes));
    add("on the grid ", pass.grid_fields);
    const std::size_t times = mpm::times_a_step(pass, problem.setup.method);
    const std::string often = pass.once   ? "; once, before the first step"
                              : times > 1 ? fmt::format("; {} times a step", times)
                                          : "";
    text += wrapped("because of " + pass.called_for_by + often, indent + "  ", indent);
  }
  return text;
}

std::string observers_text(const PosedScene& problem) {
  std::string text;
  for (const Observer& o : observers_of(problem))
    text += fmt::format("  {:19} {} times, because of {}\n", o.name, o.times, o.called_for_by);
  return text.empty() ? "nothing between steps\n" : "between steps\n" + text;
}

template <int Dim>
std::string memory_text(const ProblemIn<Dim>& problem, const Composition& c) {
  std::string text = fmt::format("particle columns, {} bytes a particle\n", c.bytes_per_particle);
  const std::string indent(34, ' ');
  for (const auto& use : c.columns) {
    const auto& info = mpm::record_of<Dim>(use.column);
    text += wrapped(std::string(info.doc), fmt::format("  {:20} {:4} bytes  ", info.name, use.bytes), indent);
  }
  const auto& grid = problem.setup.grid;
  std::string nodes;
  for (std::size_t d = 0; d < Dim; ++d) nodes += (d == 0 ? "" : " x ") + std::to_string(grid.count[d]);
  text += wrapped(fmt::format("{} nodes of {} bytes, {} of them in tiles that the particles reach at the start; "
                              "memory of the run, with lattice and samples: at most {} MiB",
                              nodes, c.bytes_per_node, grouped_text(c.nodes_reached),
                              rounded_text(problem.estimated_bytes() / (1024.0 * 1024), 3)),
                  "grid: ", "  ");
  for (const auto& use : c.grid_fields)
    text += wrapped(use.doc, fmt::format("  {:20} {:4} bytes  ", use.name, use.bytes), indent);
  return text;
}

std::string work_text(const Composition& c) {
  return wrapped(
      fmt::format("{} of columns and {} of grid fields, {} updates of the material", bytes_text(c.work.column_bytes),
                  bytes_text(c.work.grid_bytes), grouped_text(c.work.material_updates)),
      "work of a step, counted and not measured: ", "  ");
}

/// What the scene calls for, and by which key; and what it does not.
std::string effects_text(const Composition& c) {
  std::string there, absent;
  const std::string indent(22, ' ');
  for (const EffectPart& part : c.effects) {
    const EffectEntry& entry = entry_of(part.effect);
    if (!part.is_there) {
      absent += (absent.empty() ? "" : ", ") + entry.name + (entry.key.empty() ? "" : " (" + entry.key + ")");
      continue;
    }
    there += wrapped(entry.doc, fmt::format("  {:19} ", entry.name), indent);
    if (const std::string brought = brought_text(part); !brought.empty())
      there += wrapped(brought, indent + "  ", indent + "    ");
    there += wrapped("because of " + part.key, indent + "  ", indent);
  }
  return "effects, in addition to the passes of every run\n" + (there.empty() ? "  none\n" : there) +
         wrapped(absent, "not used: ", "  ");
}

template <int Dim>
std::string steps_text(const ProblemIn<Dim>& problem) {
  const Units& units = problem.scene.units;
  const std::string reference =
      problem.reference_wave_speed > 0
          ? ", " + units.text(problem.reference_wave_speed, "m/s", 4) + " across the reference configuration"
          : "";
  const std::string viscous = problem.viscous_shortening > 1
                                  ? "; artificial viscosity makes stable steps " +
                                        rounded_text(problem.viscous_shortening, 3) + " times shorter"
                                  : "";
  return fmt::format("{} particles stepped, {} held; {} steps of {}\n",
                     grouped_text(static_cast<std::int64_t>(problem.setup.seeds.size())),
                     grouped_text(static_cast<std::int64_t>(problem.setup.seeds.held.size())),
                     grouped_text(problem.steps), units.text(problem.dt, "s", 4)) +
         wrapped(fmt::format("{}{}, fastest particle {}{}", units.text(problem.wave_speed, "m/s", 4), reference,
                             units.text(problem.particle_speed, "m/s", 4), viscous),
                 "  fastest wave on the path ", "    ");
}

template <int Dim>
std::string exact_solution_line(const ProblemIn<Dim>& problem) {
  if (!problem.setup.uses_exact_solution()) return "";
  return wrapped(problem.setup.has_virtual_stress()
                     ? "forces come from the difference to the exact stress, so the error says less about the method"
                     : "particles get the acceleration of the exact motion, so the error says less about the method",
                 "uses the exact solution: ", "  ");
}

template <int Dim>
std::string ends_text(const ProblemIn<Dim>& problem) {
  constexpr const char* axes[] = {"x", "y", "z"};
  std::vector<std::string> all;
  for (std::size_t d = 0; d < Dim; ++d) {
    const mpm::AxisEnds& ends = problem.setup.ends[d];
    if (ends.periodic) {
      all.push_back(std::string("periodic along ") + axes[d]);
      continue;
    }
    for (const auto& at : {ends.lower, ends.upper}) {
      if (at)
        all.push_back(std::string("a symmetry plane at ") + axes[d] + " = " + problem.scene.units.text(*at, "m", 6));
    }
  }
  return all.empty() ? "" : wrapped(joined(all), "faces: ", "  ");
}

template <int Dim>
std::string response_text(const ProblemIn<Dim>& problem, const ExactSolution* exact) {
  if (!problem.compared) return "no body force\n";
  if (!exact) return "response: not computed, because the run is refused\n";
  const Response* response = exact->response();
  if (!response) {
    if (const auto source = exact->source(); source && !source->by.empty())
      return fmt::format("response: {}, {} at each node\n", source->what, source->by);
    const std::string forces = problem.setup.body_force ? "body force: the acceleration\n" : "no body force\n";
    const bool known = problem.material->is_function_of_F();
    return forces + (known ? "stress: of the motion's F\n" : "stress: one history, with error control\n");
  }
  const Sheet* sheet = response->sheet();
  if (const Shadow* points = response->shadow())
    return fmt::format("shadow: {} histories taken along\n", points->radii());
  if (!sheet) return "response: the material's closed form\n";
  const std::string error = fmt::format("error {} of tau, {} of d tau/d xi\n", rounded_text(sheet->error_tau(), 2),
                                        rounded_text(sheet->error_dtau(), 2));
  if (sheet->is_curve()) return fmt::format("sheet: a curve tau(eps) of {} points, {}", sheet->points(), error);
  return fmt::format("sheet: {} x {} = {} points, {}", sheet->nodes_in_xi(), sheet->nodes_in_t(),
                     grouped_text(sheet->points()), error);
}

using Json = nlohmann::ordered_json;

template <int Dim>
Json written(const mpm::PassInfo& pass, const mpm::Setup<Dim>& setup) {
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

template <int Dim>
std::string explanation(const ProblemIn<Dim>& problem, const ExactSolution* exact, const ScreenFigures& screen) {
  const Composition c = composition_of(problem);
  const auto& turned = problem.scene.frame;
  const std::string frame = turned ? wrapped(frame_text(*turned), "frame: ", "  ") : "";
  return passes_text(problem, c) + observers_text(problem) + memory_text(problem, c) + work_text(c) + effects_text(c) +
         steps_text(problem) + frame + exact_solution_line(problem) + ends_text(problem) +
         response_text(problem, exact) + wrapped(screen_sentence(screen, problem.scene.units), "motion: ", "  ");
}

template <int Dim>
std::string explanation_json(const ProblemIn<Dim>& problem, const ExactSolution* exact, const ScreenFigures& screen) {
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
  json["sheet"] = written(exact && exact->response() ? exact->response()->sheet() : nullptr);
  json["screen"] = {{"verdict", screen.verdict}, {"smallest", *screen.smallest}, {"unjudged", screen.unjudged}};
  if (screen.largest_safe_amplitude) json["screen"]["largest_safe_amplitude"] = *screen.largest_safe_amplitude;
  return json_document(json);
}

template std::string explanation(const ProblemIn<2>&, const ExactSolution*, const ScreenFigures&);
template std::string explanation(const ProblemIn<3>&, const ExactSolution*, const ScreenFigures&);
template std::string explanation_json(const ProblemIn<2>&, const ExactSolution*, const ScreenFigures&);
template std::string explanation_json(const ProblemIn<3>&, const ExactSolution*, const ScreenFigures&);

}  // namespace assay::drivers
