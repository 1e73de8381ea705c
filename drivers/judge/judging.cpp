// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/judge/judging.hpp"

#include <algorithm>
#include <functional>

#include "drivers/findings/findings.hpp"
#include "drivers/judge/changes.hpp"
#include "drivers/mistakes/perturbed_scene.hpp"
#include "drivers/output/errors_csv.hpp"
#include "drivers/scene/body_box.hpp"
#include "drivers/scene/expect.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/problem.hpp"
#include "drivers/simulation/response_source.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

template <int Dim>
BodyPlace place_of_body(const Scene& scene) {
  const BoxOf<Dim> box = body_box<Dim>(scene);
  BodyPlace place;
  for (std::size_t d = 0; d < Dim; ++d) {
    place.centre[static_cast<int>(d)] = 0.5 * (box.lower[d] + box.upper[d]);
    place.size = std::max(place.size, box.upper[d] - box.lower[d]);
  }
  return place;
}

/// Of the k-th run.
void take_cost(const JudgeCost& cost, std::size_t k, std::size_t runs, const std::string& file, JudgedGrid& grid) {
  if (cost.seconds.empty()) return;
  if (cost.seconds.size() > 1 && cost.seconds.size() != runs) {
    throw InputError({file, 0, 0}, "cost.seconds",
                     "has " + std::to_string(cost.seconds.size()) + " numbers for " + std::to_string(runs) + " runs");
  }
  grid.seconds = cost.seconds[cost.seconds.size() > 1 ? k : 0];
  grid.cores = cost.cores, grid.machine = cost.machine;
}

/// Throws InputError where the spacings that are given do not go with the distances between particles.
void check_spacings(const std::vector<JudgedGrid>& runs, std::vector<std::string>& warnings) {
  constexpr double far = 30;
  for (const JudgedGrid& a : runs) {
    for (const JudgedGrid& b : runs) {
      if (*a.h > 1.01 * *b.h && *a.spacing * 1.5 < *b.spacing) {
        throw InputError({}, "--h",
                         "gives " + rounded_text(*a.h, 4) + " for " + a.name +
                             ", whose particles are closer than those of " + b.name + " with " + rounded_text(*b.h, 4) +
                             ": spacings are in the order of the runs");
      }
    }
    constexpr double apart = 3;  // a cell with less than a particle in it
    if (*a.h > far * *a.spacing || apart * *a.h < *a.spacing) {
      warnings.push_back("--h gives " + rounded_text(*a.h, 4) + " m for " + a.name + ", whose particles are " +
                         rounded_text(*a.spacing, 3) + " m apart");
    }
  }
}

/// The runs become ones without the labels that are found, clocks that are doubtful left out. spacing: of each run's
/// particles [m].
void take_labels(std::vector<JudgedRun>& runs, const std::vector<double>& spacing, std::vector<std::string>& warnings,
                 std::vector<std::vector<Label>>& labels,
                 const std::function<std::vector<Label>(const JudgedRun&, const Causes&)>& found_in) {
  Causes left_out;
  std::vector<std::vector<Label>> found(runs.size());
  for (bool again = true; again;) {
    for (std::size_t k = 0; k < runs.size(); ++k) {
      found[k] = found_in(runs[k], left_out);
      stop_if_interrupted();
    }
    const std::vector<DoubtfulClock> doubtful = doubtful_clocks(found, spacing);
    for (const DoubtfulClock& each : doubtful) {
      left_out.push_back(each.cause);
      if (each.cause == clock_rate) left_out.push_back(clock_offset);  // the next best of the same
      warnings.push_back(each.sentence);
    }
    again = !doubtful.empty();
  }
  for (std::size_t k = 0; k < runs.size(); ++k) {
    take(found[k], runs[k]);
    labels[k].insert(labels[k].end(), found[k].begin(), found[k].end());
  }
}

}  // namespace

std::vector<Expectation> expected_of_any_code(const Scene& scene, bool all) {
  std::vector<Expectation> lines;
  for (const Expectation& line : scene.expect) {
    if (is_of_order(line) || (all && line.key.starts_with("error."))) lines.push_back(line);
  }
  return lines;
}

JudgeFindings findings_of(Scene scene, const JudgeTask& task) {
  if (!task.map.scene_sha256.empty() && task.map.scene_sha256 != scene.sha256)
    throw InputError({task.map_file, 0, 0}, "scene_sha256", "is of another scene than " + scene.file);
  JudgeFindings findings;
  findings.title = scene.title, findings.scene = scene.file, findings.code = task.map.code;
  std::string library;
  const auto material = material_of(scene, library);
  findings.provenance = build_information();
  findings.provenance.scene_sha256 = scene.sha256;
  findings.provenance.material = material_provenance(*material, library);
  const int dimension = scene.dimension;
  const BodyPlace body = dimension == 3 ? place_of_body<3>(scene) : place_of_body<2>(scene);
  std::vector<JudgedRun> runs;
  ExactParticles motion(motion_alone(scene, material), dimension);
  double end = scene.time.end;
  bool stress = false;
  for (const std::string& name : task.runs) {
    runs.push_back(read_judged_run(name, task.map, dimension));
    stress = stress || !runs.back().frames.back().sigma.empty();
    stop_if_interrupted();
  }
  std::vector<double> spacing;
  for (const JudgedRun& run : runs) spacing.push_back(seeds_of(run, motion).spacing);
  std::vector<std::vector<Label>> labels(runs.size());
  take_labels(runs, spacing, findings.warnings, labels, [&](const JudgedRun& run, const Causes& left_out) {
    return position_labels(run, body, motion, left_out);
  });
  for (const JudgedRun& run : runs) {
    end = std::max(end, run.frames.back().t);
    if (const std::string words = size_words(seeds_of(run, motion), body); !words.empty())
      findings.warnings.push_back(run.name + ": " + words);
  }
  if (scene.force.response == ForceChoice::Response::none) scene.force.response = ForceChoice::Response::sheet;
  ExactParticles exact(
      stress ? exact_solution_of_points(scene, material, end, task.quiet) : motion_alone(scene, material), dimension);
  take_labels(runs, spacing, findings.warnings, labels,
              [&](const JudgedRun& run, const Causes& left_out) { return field_labels(run, exact, left_out); });
  const std::string why_not = why_no_mistakes(scene);
  if (!why_not.empty()) findings.code_findings.sentence = "mistakes of the code are not looked for " + why_not;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const JudgeCost cost = runs[k].map.cost;
    JudgedGrid grid = judged_grid(std::move(runs[k]), labels[k], 0.5 * scene.motion->period(), scene.time.end, exact,
                                  why_not.empty() ? std::optional(bins_of(scene)) : std::nullopt, findings.warnings);
    if (!task.h.empty()) grid.h = task.h[k];
    take_cost(cost, k, runs.size(), task.map_file, grid);
    findings.runs.push_back(std::move(grid));
    stop_if_interrupted();
  }
  if (!task.h.empty()) check_spacings(findings.runs, findings.warnings);
  std::ranges::stable_sort(findings.runs, std::greater(), [](const JudgedGrid& grid) { return grid.h.value_or(0); });
  find_mistakes(findings, scene, material, task.quiet);
  conclude(findings, task.expected);
  return findings;
}

std::vector<std::string> judge_files() {
  return {"judge.json", "report.html", "errors.csv", "errors_#.csv", "error.png", "resolved.yaml"};
}

std::string write_findings(const JudgeFindings& findings, const Scene& scene, OutputFolder& folder) {
  for (std::size_t k = 0; k < findings.runs.size(); ++k) {
    const bool finest = k + 1 == findings.runs.size();
    folder.write(finest ? "errors.csv" : "errors_" + std::to_string(k + 1) + ".csv",
                 errors_csv(findings.runs[k].history));
  }
  if (!findings.runs.back().picture.empty()) folder.write("error.png", findings.runs.back().picture);
  const std::string resolved = resolved_yaml(scene);
  folder.write("resolved.yaml", resolved);
  folder.write("report.html", judge_html(findings, resolved, scene.motion->period()));
  return judge_json(findings);
}

}  // namespace assay::drivers
