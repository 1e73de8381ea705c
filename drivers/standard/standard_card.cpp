// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/standard/standard_card.hpp"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "drivers/judge/judging.hpp"
#include "drivers/result/json_fields.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/problem.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/progress.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

namespace fs = std::filesystem;

/// In a folder of a grid that `assay export` has made, what the code has left there: out.csv, out.npz, a folder out.
fs::path output_of(const fs::path& grid) {
  std::error_code code;
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(grid, code)) {
    if (entry.path().stem() == "out") found.push_back(entry.path());
  }
  return found.size() == 1 ? found[0] : grid;
}

/// Whether an export lies there that has no output yet.
bool is_not_run(const fs::path& grid) {
  std::error_code code;
  return output_of(grid) == grid && fs::is_regular_file(grid / "seeds.csv", code);
}

/// What lies in a folder under names that end with a spacing, the coarsest first.
std::vector<std::pair<double, std::string>> grids_in(const fs::path& folder) {
  std::vector<std::pair<double, std::string>> grids;
  std::error_code code;
  for (const auto& entry : fs::directory_iterator(folder, code)) {
    if (const auto h = grid_of_name(entry.path().filename().string()); h && !is_not_run(entry.path()))
      grids.emplace_back(*h, output_of(entry.path()).string());
  }
  std::ranges::sort(grids, std::greater());
  return grids;
}

/// Motion, material and times, which a problem and its export have in common, with what the library of the material
/// says of it.
std::string physics_of(Scene scene) {
  std::string library, physics;
  material_of(scene, library);
  const std::string resolved = resolved_yaml(scene);
  bool inside = false;
  for (const std::string_view line : split(resolved, '\n')) {
    if (!line.starts_with(' '))
      inside = line.starts_with("motion:") || line.starts_with("material:") || line.starts_with("time:");
    if (inside) physics += std::string(line) + "\n";
  }
  return physics;
}

/// The scene that was run: the problem's own, or that of an export, whose hash the map may know. Throws InputError
/// where it is another problem.
Scene scene_that_was_run(const StandardProblem& problem, const fs::path& folder) {
  std::error_code code;
  const fs::path exported = folder / "scene.yaml";
  Scene scene = problem.scene();
  if (!fs::is_regular_file(exported, code)) return scene;
  const Scene run = read_scene(exported.string());
  if (physics_of(run) != physics_of(scene)) {
    throw InputError({exported.string(), 0, 0}, "",
                     "is another problem than " + problem.id + ": its motion, material or times differ");
  }
  scene.sha256 = run.sha256;
  return scene;
}

/// A map of the problem, else of the whole folder.
std::string map_of(const fs::path& problem) {
  std::error_code code;
  for (const fs::path& folder : {problem, problem.parent_path()}) {
    const fs::path file = folder / "judge.map.yaml";
    if (fs::is_regular_file(file, code)) return file.string();
  }
  return {};
}

}  // namespace

std::size_t CardCode::run() const {
  return static_cast<std::size_t>(std::ranges::count_if(rows, [](const CardRow& row) { return row.was_run(); }));
}

std::size_t CardCode::passed() const {
  return static_cast<std::size_t>(std::ranges::count_if(rows, [](const CardRow& row) { return row.good; }));
}

CardRow row_of(const StandardProblem& problem, const JudgeFindings& findings) {
  CardRow row;
  row.id = problem.id, row.title = findings.title, row.good = findings.good, row.found = findings.verdict;
  row.order = findings.order, row.order_lower = findings.order_lower, row.order_upper = findings.order_upper;
  row.last_order = findings.last_order;
  for (const MistakeFigures& each : findings.code_findings.mistakes) {
    if (each.named) row.causes.push_back(each.mistake);
  }
  for (const JudgedGrid& run : findings.runs) {
    CardGrid grid{run.h, run.error.l2_max, run.error.relative, {}};
    if (run.seconds) grid.core_s = *run.seconds * run.cores.value_or(1);
    row.grids.push_back(grid);
    for (const LabelFigures& label : run.labels) {
      if (std::ranges::find(row.causes, label.cause) == row.causes.end()) row.causes.push_back(label.cause);
    }
  }
  return row;
}

CardRow row_without(const StandardProblem& problem, const std::string& why) {
  CardRow row;
  row.id = problem.id, row.title = problem.scene().title, row.found = why;
  return row;
}

CardCode judged_code(const StandardSet& set, const std::string& folder, const std::string& out, bool quiet) {
  std::error_code code;
  if (!fs::is_directory(folder, code)) throw InputError({folder, 0, 0}, "", "is no folder of results");
  CardCode card{.name = fs::path(folder).lexically_normal().filename().string(), .machine = {}, .rows = {}};
  Progress progress("judging " + card.name, quiet);
  for (std::size_t k = 0; k < set.problems.size(); ++k) {
    const StandardProblem& problem = set.problems[k];
    progress.update(static_cast<double>(k) / static_cast<double>(set.problems.size()), problem.id);
    const auto grids = grids_in(fs::path(folder) / problem.id);
    if (grids.empty()) {
      card.rows.push_back(row_without(problem, "not run"));
      continue;
    }
    const Scene scene = scene_that_was_run(problem, fs::path(folder) / problem.id);
    JudgeTask task;
    for (const auto& [h, run] : grids) task.h.push_back(h), task.runs.push_back(run);
    task.map_file = map_of(fs::path(folder) / problem.id);
    if (!task.map_file.empty()) task.map = read_judge_map(task.map_file);
    task.expected = expected_of_any_code(scene, true);
    task.quiet = true;
    const JudgeFindings findings = findings_of(scene, task);
    OutputFolder files(fs::path(out) / problem.id, judge_files());
    const std::string json = write_findings(findings, scene, files);
    files.write("judge.json", json);
    files.commit();
    if (!findings.code.empty()) card.name = findings.code;
    for (const JudgedGrid& grid : findings.runs) {
      if (!grid.machine.empty()) card.machine = grid.machine;
    }
    CardRow row = row_of(problem, findings);
    constexpr double same = 1.01;
    if (task.h.back() > same * problem.grids.back()) {
      row.good = false;
      row.found = "the finest grid, h = " + rounded_text(problem.grids.back(), 4) + ", was not run; " + row.found;
    }
    card.rows.push_back(std::move(row));
  }
  if (card.run() == 0) {
    throw InputError({folder, 0, 0}, "", "holds no results of the standard set: they lie in ID/h_0.1, ID/h_0.05, ...",
                     joined(set.problems, [](const StandardProblem& one) { return one.id; }));
  }
  return card;
}

std::string card_json(const StandardCard& card) { return json_document(JsonFields<nlohmann::ordered_json>::of(card)); }

}  // namespace assay::drivers
