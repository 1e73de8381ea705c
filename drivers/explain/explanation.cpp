// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/explain/explanation.hpp"

#include <fmt/core.h>
#include <cmath>
#include <cstdio>

#include "drivers/explain/composition.hpp"
#include "drivers/findings/findings.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/response_source.hpp"
#include "drivers/simulation/screening.hpp"
#include "drivers/simulation/warnings.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/terminal.hpp"
#include "drivers/text/number_format.hpp"
#include "drivers/text/wrapped_text.hpp"
#include "mpm/step/stages.hpp"

namespace assay::drivers {

namespace {

std::string columns_text(const std::vector<mpm::Column>& columns) {
  std::string text;
  for (const mpm::Column column : columns) text += (text.empty() ? "" : ", ") + std::string(mpm::info(column).name);
  return text;
}

std::string bytes_text(double bytes) { return rounded_text(bytes / (1024.0 * 1024), 3) + " MiB"; }

/// "passes ...; columns ...; grid fields ..., 16 bytes a particle".
std::string brought_text(const EffectPart& part) {
  std::string text;
  const auto add = [&](const std::string& what) { text += (text.empty() ? "" : "; ") + what; };
  if (!part.passes.empty()) add("pass " + joined(part.passes));
  if (!part.columns.empty())
    add("column " + joined(part.columns) + fmt::format(", {} bytes a particle", part.bytes_per_particle));
  if (!part.grid_fields.empty()) {
    add("grid field " + joined(part.grid_fields) + fmt::format(", {} bytes a node", part.bytes_per_node));
  }
  const EffectEntry& entry = entry_of(part.effect);
  if (!entry.around.empty()) add(entry.around);
  if (entry.asks_material) add("calls of the material beside the particles' stress");
  return text;
}

std::string passes_text(const Problem& problem, const Composition& c) {
  std::string text = "passes of a step\n";
  const std::string indent(22, ' ');
  for (const auto& pass : c.passes) {
    text += wrapped(pass.doc, fmt::format("  {:19} ", pass.name), indent);
    if (!pass.reads.empty()) text += wrapped("reads " + columns_text(pass.reads), indent + "  ", indent + "    ");
    if (!pass.writes.empty()) text += wrapped("writes " + columns_text(pass.writes), indent + "  ", indent + "    ");
    if (!pass.grid_fields.empty()) {
      text += wrapped("on the grid " + joined(pass.grid_fields), indent + "  ", indent + "    ");
    }
    const std::size_t times = mpm::times_a_step(pass, problem.setup.method);
    const std::string often = pass.once   ? "; once, before the first step"
                              : times > 1 ? fmt::format("; {} times a step", times)
                                          : "";
    text += wrapped("because of " + pass.called_for_by + often, indent + "  ", indent);
  }
  return text;
}

std::string observers_text(const Problem& problem) {
  std::string text;
  for (const Observer& o : observers_of(problem)) {
    text += fmt::format("  {:19} {} times, because of {}\n", o.name, o.times, o.called_for_by);
  }
  return text.empty() ? "nothing between steps\n" : "between steps\n" + text;
}

std::string memory_text(const Problem& problem, const Composition& c) {
  std::string text = fmt::format("particle columns, {} bytes a particle\n", c.bytes_per_particle);
  const std::string indent(34, ' ');
  for (const auto& use : c.columns) {
    const auto& info = mpm::info(use.column);
    text += wrapped(std::string(info.doc), fmt::format("  {:20} {:4} bytes  ", info.name, use.bytes), indent);
  }
  const auto& grid = problem.setup.grid;
  text += wrapped(fmt::format("{} x {} nodes of {} bytes, {} of them in tiles that the particles reach at the start; "
                              "memory of the run, with lattice and samples: at most {} MiB",
                              grid.count[0], grid.count[1], c.bytes_per_node, grouped_text(c.nodes_reached),
                              rounded_text(problem.estimated_bytes() / (1024.0 * 1024), 3)),
                  "grid: ", "  ");
  for (const auto& use : c.grid_fields) {
    text += wrapped(use.doc, fmt::format("  {:20} {:4} bytes  ", use.name, use.bytes), indent);
  }
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
    if (const std::string brought = brought_text(part); !brought.empty()) {
      there += wrapped(brought, indent + "  ", indent + "    ");
    }
    there += wrapped("because of " + part.key, indent + "  ", indent);
  }
  return "effects, in addition to the passes of every run\n" + (there.empty() ? "  none\n" : there) +
         wrapped(absent, "not used: ", "  ");
}

std::string steps_text(const Problem& problem) {
  const std::string reference =
      problem.reference_wave_speed > 0
          ? ", " + rounded_text(problem.reference_wave_speed, 4) + " m/s across the reference configuration"
          : "";
  const std::string viscous = problem.viscous_shortening > 1
                                  ? "; artificial viscosity makes stable steps " +
                                        rounded_text(problem.viscous_shortening, 3) + " times shorter"
                                  : "";
  return fmt::format("{} particles stepped, {} held; {} steps of {} s\n",
                     grouped_text(static_cast<std::int64_t>(problem.setup.seeds.size())),
                     grouped_text(static_cast<std::int64_t>(problem.setup.seeds.held.size())),
                     grouped_text(problem.steps), rounded_text(problem.dt, 4)) +
         wrapped(fmt::format("{} m/s{}, fastest particle {} m/s{}", rounded_text(problem.wave_speed, 4), reference,
                             rounded_text(problem.particle_speed, 4), viscous),
                 "  fastest wave on the path ", "    ");
}

std::string frame_line(const Problem& problem) {
  return problem.scene.frame ? wrapped(frame_text(*problem.scene.frame), "frame: ", "  ") : "";
}

std::string exact_solution_line(const Problem& problem) {
  if (!problem.setup.uses_exact_solution()) return "";
  return wrapped(problem.setup.has_virtual_stress()
                     ? "forces come from the difference to the exact stress, so the error says less about the method"
                     : "particles get the acceleration of the exact motion, so the error says less about the method",
                 "uses the exact solution: ", "  ");
}

std::string ends_text(const Problem& problem) {
  constexpr const char* axes[] = {"x", "y"};
  std::string text;
  for (std::size_t d = 0; d < 2; ++d) {
    const mpm::AxisEnds& ends = problem.setup.ends[d];
    const auto add = [&](const std::string& what) { text += (text.empty() ? "" : ", ") + what; };
    if (ends.periodic) {
      add(std::string("periodic along ") + axes[d]);
      continue;
    }
    for (const auto& at : {ends.lower, ends.upper}) {
      if (at) add(std::string("a symmetry plane at ") + axes[d] + " = " + rounded_text(*at, 6) + " m");
    }
  }
  return text.empty() ? "" : wrapped(text, "faces: ", "  ");
}

std::string response_text(const Problem& problem, const ExactSolution* exact) {
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

}  // namespace

std::string explanation(const Problem& problem, const ExactSolution* exact, const ScreenFigures& screen, bool json) {
  const Composition c = composition_of(problem);
  if (json) return explanation_json(problem, c, exact ? exact->response() : nullptr, screen);
  return passes_text(problem, c) + observers_text(problem) + memory_text(problem, c) + work_text(c) + effects_text(c) +
         steps_text(problem) + frame_line(problem) + exact_solution_line(problem) + ends_text(problem) +
         response_text(problem, exact) + wrapped(screen_sentence(screen), "motion: ", "  ");
}

}  // namespace assay::drivers
