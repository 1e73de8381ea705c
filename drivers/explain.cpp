// SPDX-License-Identifier: BSD-3-Clause
// `assay explain`: what a run of a scene consists of. No particle moves.
#include <fmt/core.h>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "drivers/explanation.hpp"
#include "drivers/findings.hpp"
#include "drivers/output/number_format.hpp"
#include "drivers/output/wrapped_text.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/screening.hpp"
#include "drivers/simulation/response_source.hpp"
#include "drivers/simulation/simulate.hpp"
#include "drivers/verbs.hpp"
#include "mpm/stages.hpp"

namespace assay::drivers {

namespace {

std::string columns_text(const std::vector<mpm::Column>& columns) {
  std::string text;
  for (const mpm::Column column : columns) text += (text.empty() ? "" : ", ") + std::string(mpm::info(column).name);
  return text;
}

struct Composition {
  std::vector<mpm::Pass<2>> passes;
  std::vector<mpm::ColumnUse> columns;
  std::size_t bytes_per_particle = 0, bytes_per_node = 0;
};

Composition composition_of(const Problem& problem) {
  Composition c;
  c.passes = mpm::compose(problem.setup);
  c.columns = mpm::columns_of(c.passes, problem.setup);
  for (const auto& use : c.columns) c.bytes_per_particle += use.bytes;
  c.bytes_per_node = mpm::grid_bytes_per_node(problem.setup);
  return c;
}

std::string passes_text(const Problem& problem, const Composition& c) {
  std::string text = "passes of a step\n";
  const std::string indent(22, ' ');
  for (const auto& pass : c.passes) {
    text += wrapped(pass.doc, fmt::format("  {:20}", pass.name), indent);
    if (!pass.reads.empty()) text += wrapped("reads " + columns_text(pass.reads), indent + "  ", indent + "    ");
    if (!pass.writes.empty()) text += wrapped("writes " + columns_text(pass.writes), indent + "  ", indent + "    ");
    const std::size_t times = mpm::times_a_step(pass, problem.setup.method);
    const std::string often = pass.once   ? "; once, before the first step"
                              : times > 1 ? fmt::format("; {} times a step", times)
                                          : "";
    text += wrapped("because of " + pass.called_for_by + often, indent + "  ", indent);
  }
  return text;
}

/// What a run does between steps, under the names of its profile.
struct Observer {
  std::string name;
  std::size_t times;
  std::string called_for_by;
};

std::vector<Observer> observers_of(const Problem& problem) {
  const Observations due = observations_of(problem);
  std::vector<Observer> list;
  if (!due.samples.empty()) list.push_back({"error_sampling", due.samples.size(), "output.errors"});
  if (!due.shots.empty()) {
    list.push_back(
        {"snapshots", due.shots.size(), problem.scene.output.particles > 0 ? "output.particles" : "output.pictures"});
  }
  return list;
}

std::string observers_text(const Problem& problem) {
  std::string text;
  for (const Observer& o : observers_of(problem)) {
    text += fmt::format("  {:20}{} times, because of {}\n", o.name, o.times, o.called_for_by);
  }
  return text.empty() ? "nothing between steps\n" : "between steps\n" + text;
}

std::string memory_text(const Problem& problem, const Composition& c) {
  std::string text = fmt::format("particle columns, {} bytes a particle\n", c.bytes_per_particle);
  for (const auto& use : c.columns) {
    const mpm::ColumnInfo info = mpm::info(use.column);
    text +=
        wrapped(std::string(info.doc), fmt::format("  {:20} {:4} bytes  ", info.name, use.bytes), std::string(34, ' '));
  }
  const auto& grid = problem.setup.grid;
  return text + fmt::format("grid: {} x {} nodes of {} bytes; in all about {} MiB\n", grid.count[0], grid.count[1],
                            c.bytes_per_node, rounded_text(problem.estimated_bytes() / (1024.0 * 1024), 3));
}

std::string steps_text(const Problem& problem) {
  return fmt::format(
      "{} particles stepped, {} held; {} steps of {} s\n  fastest wave on the path {} m/s, fastest particle "
      "{} m/s\n",
      grouped_text(static_cast<std::int64_t>(problem.setup.seeds.size())),
      grouped_text(static_cast<std::int64_t>(problem.setup.seeds.held.size())), grouped_text(problem.steps),
      rounded_text(problem.dt, 4), rounded_text(problem.wave_speed, 4), rounded_text(problem.particle_speed, 4));
}

std::string frame_line(const Problem& problem) {
  return problem.scene.frame ? wrapped(frame_text(*problem.scene.frame), "frame: ", "  ") : "";
}

std::string exact_solution_line(const Problem& problem) {
  if (!problem.setup.uses_exact_solution()) return "";
  return wrapped(problem.setup.has_virtual_stress()
                     ? "forces are those of the stress beyond the exact one: the error says less of the method"
                     : "particles are given the inertia of the exact motion: the error says less of the method",
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
  if (!exact) return "";
  if (exact->box()) {
    const BoxStress& box = **exact->box();
    return fmt::format("response: a cosine series of {} x {} modes, {} at each node\n", box.modes(0), box.modes(1),
                       box.is_history() ? "a history" : "an update");
  }
  const Response* response = exact->response() ? exact->response()->get() : nullptr;
  if (!response) {
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

std::string json_text(const Problem& problem, const Composition& c, const Response* response,
                      const ScreenFigures& screen) {
  nlohmann::ordered_json json;
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
                              {"called_for_by", pass.called_for_by}});
  }
  json["observers"] = nlohmann::ordered_json::array();
  for (const Observer& o : observers_of(problem)) {
    json["observers"].push_back({{"name", o.name}, {"times", o.times}, {"called_for_by", o.called_for_by}});
  }
  for (const auto& use : c.columns) {
    json["columns"].push_back(
        {{"name", mpm::info(use.column).name}, {"bytes_per_particle", use.bytes}, {"passes", use.passes}});
  }
  json["bytes_per_particle"] = c.bytes_per_particle;
  json["bytes_per_node"] = c.bytes_per_node;
  json["nodes"] = problem.setup.grid.nodes();
  json["particles"] = problem.particles();
  json["stepped_particles"] = problem.setup.seeds.size();
  json["uses_exact_solution"] = problem.setup.uses_exact_solution();
  json["steps"] = problem.steps;
  json["dt"] = problem.dt;
  json["wave_speed"] = problem.wave_speed;
  const Sheet* sheet = response ? response->sheet() : nullptr;
  if (sheet) {
    json["sheet"] = {
        {"points", sheet->points()}, {"error_tau", sheet->error_tau()}, {"error_dtau", sheet->error_dtau()}};
  } else {
    json["sheet"] = nullptr;
  }
  json["screen"] = {{"verdict", screen.verdict}, {"smallest", *screen.smallest}, {"unjudged", screen.unjudged}};
  if (screen.largest_safe_amplitude) json["screen"]["largest_safe_amplitude"] = *screen.largest_safe_amplitude;
  return json.dump(2) + "\n";
}

}  // namespace

std::string explanation(const Problem& problem, const ExactSolution* exact, const ScreenFigures& screen, bool json) {
  const Composition c = composition_of(problem);
  if (json) return json_text(problem, c, exact && exact->response() ? exact->response()->get() : nullptr, screen);
  return passes_text(problem, c) + observers_text(problem) + memory_text(problem, c) + steps_text(problem) +
         frame_line(problem) + exact_solution_line(problem) + ends_text(problem) + response_text(problem, exact) +
         wrapped(screen_sentence(screen), "motion: ", "  ");
}

int explain(const ExplainOptions& options) {
  try {
    const Problem problem = assemble(read_scene(options.scene, options.sets), 1);
    std::shared_ptr<const ExactSolution> exact;
    if (problem.compared) exact = exact_solution_of(problem.scene, problem.material, problem.scene.time.end);
    const ScreenFigures screen = screen_of(problem.scene, *problem.material, problem.scene.time.end);
    const std::string text = explanation(problem, exact.get(), screen, options.json);
    std::fputs(text.c_str(), stdout);
    return 0;
  } catch (const MaterialFailure& failure) {
    Result result;
    record_failure(failure, result);
    std::fprintf(stderr, "%s\n", result.reason.c_str());
    return 1;
  }
}

}  // namespace assay::drivers
