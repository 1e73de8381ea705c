// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/path/path_tabulation.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "adapters/foreign/foreign_state.hpp"
#include "drivers/findings/findings.hpp"
#include "drivers/material/material_choice.hpp"
#include "drivers/output/output_folder.hpp"
#include "drivers/path/path_result.hpp"
#include "drivers/result/json_fields.hpp"
#include "drivers/scene/expect.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/system/progress.hpp"
#include "drivers/system/terminal.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/words.hpp"
#include "drivers/text/wrapped_text.hpp"
#include "harness/material/initial_stress.hpp"

namespace assay::drivers {

namespace {

using Json = nlohmann::ordered_json;

std::string expected_text(const PathResult& result, bool that_hold) {
  Result lines;
  lines.expect = result.expect;
  return expectations_text(lines, that_hold);
}

/// Whose figure a key names: the label of a variant, none for the path's own, and the key without that prefix.
struct NamedFigure {
  std::string label, key;
  bool of_column() const { return key.starts_with("last.") || key.starts_with("largest."); }
  std::string column() const { return key.substr(key.find('.') + 1); }
};

NamedFigure named_figure(const PathScene& scene, const std::string& key) {
  NamedFigure found{"", key};
  for (const PathVariant& variant : scene.variants) {
    const std::string prefix = "variants." + variant.label + ".";
    if (key.starts_with(prefix) && variant.label.size() > found.label.size())
      found = {variant.label, key.substr(prefix.size())};
  }
  return found;
}

std::vector<ExpectationOutcome> judged_path(const PathScene& scene, const PathResult& result) {
  const auto figures = path_figures(result);
  std::vector<ExpectationOutcome> all;
  for (const Expectation& line : scene.expect) {
    FlatValue value;
    if (line.key == "outcome") value = result.own.outcome;
    for (const PathFindings& variant : result.variants) {
      if (line.key == "variants." + variant.label + ".outcome") value = variant.outcome;
    }
    const auto found = figures.find(line.key);
    if (found != figures.end()) value = found->second;
    if (found == figures.end() && !result.own.last.empty() && named_figure(scene, line.key).of_column()) {
      std::vector<std::string> names;
      for (const auto& [name, last] : result.own.last) names.push_back(name);
      throw InputError(line.where, "expect." + line.key, "is no column of path.csv", joined(names));
    }
    all.push_back(judged(line, value));
  }
  return all;
}

/// Lines in SI, as resolved.yaml has them, but those of a column that the table has not.
std::vector<Expectation> expected_in_si(const PathScene& scene, const PathTable& table) {
  std::vector<Expectation> lines;
  for (Expectation line : scene.expect) {
    const NamedFigure figure = named_figure(scene, line.key);
    const auto found = std::ranges::find(table.names, figure.column());
    const bool is_known = found != table.names.end();
    if (figure.of_column() && !is_known && figure.label.empty()) continue;
    const bool of_time = figure.key == "t" || figure.key == "loses_ellipticity";
    const bool converts = figure.of_column() && is_known;  // what a variant's model alone keeps has its own unit
    const Scale scale =
        scene.units.scale(converts  ? table.si_units[static_cast<std::size_t>(found - table.names.begin())]
                          : of_time ? "s"
                                    : "1");
    line.number = scale.to_si(line.number), line.upper = scale.to_si(line.upper);
    lines.push_back(std::move(line));
  }
  return lines;
}

int status_of(const PathResult& result) {
  Result figures;
  figures.expect = result.expect;
  const auto whole = [](const PathFindings& found) { return is_one_of(found.outcome, {"completed", "stopped"}); };
  figures.outcome = whole(result.own) ? "completed" : result.own.outcome;
  for (const PathFindings& variant : result.variants) {
    const std::string key = "variants." + variant.label + ".outcome";
    if (!whole(variant) && std::ranges::find(result.expect, key, &ExpectationOutcome::key) == result.expect.end())
      return 1;
  }
  return exit_status(figures);
}

}  // namespace

std::string path_result_json(const PathResult& result) { return json_document(JsonFields<Json>::of(result)); }

bool is_path_text(std::string_view text, const std::string& file) { return is_path_scene(read_yaml(text, file)); }

Tree path_tree(std::string_view text, const std::string& file, const std::vector<std::string>& sets) {
  Tree root = read_yaml(text, file);
  for (const std::string& setting : sets) apply_setting(root, parse_setting(setting));
  return root;
}

int tabulate_path(const Tree& root, const std::string& sha256, const SceneOptions& options) {
  const Stopwatch life;
  PathScene scene = path_scene_of(root, options.scene, sha256);
  watch_interrupts();
  std::vector<ResolvedMaterial> materials;
  const auto resolve = [&](MaterialChoice& choice) {
    materials.push_back(resolve_path_material(scene, choice));
    choice = materials.back().choice;
  };
  resolve(scene.material);
  for (PathVariant& variant : scene.variants) resolve(variant.material);
  for (const ResolvedMaterial& material : materials) {
    for (const std::string& sentence : material.warnings) warn(sentence);
  }
  for (const ResolvedMaterial& material : materials) {
    const std::string fault = fault_of_initial_stress(material.material, symmetric_tensor(scene.initial_stress));
    if (!fault.empty())
      throw InputError(scene.initial_where,
                       key_path(scene.section, scene.confinement ? "confinement" : "initial_stress"),
                       one_line(fault, 400));
  }
  OutputFolder folder(options.out);
  folder.keep_inputs();
  PathResult result;
  result.title = scene.title;
  result.units = {scene.units.length, scene.units.stress, scene.units.time};
  result.provenance = build_information();
  result.provenance.scene_sha256 = sha256;
  result.provenance.material = material_provenance(materials[0].material, materials[0].library);
  std::vector<NamedTable> tables;
  Progress progress("path", options.quiet());
  Result process;  // what the model has done to its own
  std::optional<KeptAfterInterrupt> kept;
  for (std::size_t k = 0; k < materials.size(); ++k) {
    const std::string label = k == 0 ? "" : scene.variants[k - 1].label;
    const auto& foreign = materials[k].foreign;
    std::string note;
    const bool in_plane = foreign && adapters::is_of_plane_stress(*foreign);
    const PathScene path = in_plane ? path_of_plane_stress(scene, *foreign, note) : scene;
    PathRun run = run_path(path, materials[k].material, [&](double share) {
      progress.update((static_cast<double>(k) + share) / static_cast<double>(materials.size()));
    });
    if (interrupted() && !kept) kept.emplace();
    run.findings.label = label;
    if (in_plane) run.findings.warnings.insert(run.findings.warnings.begin(), note);
    if (k == 0) {
      run.findings.warnings.insert(run.findings.warnings.begin(), scene.warnings.begin(), scene.warnings.end());
      record_process(materials[0].material, process);
      for (const std::string& warning : process.warnings) run.findings.warnings.push_back(warning);
      if (run.failure && run.failure->step)
        process.failed_step = std::make_shared<const FailedStep>(*run.failure->step);
      process.reason = run.findings.reason;
    }
    const std::string number = k == 0 ? "" : "_" + std::to_string(k);
    PathAccuracy accuracy;
    try {
      if (!kept)
        accuracy = path_accuracy(path, materials[k].material, label, [&](double share) {
          progress.update((static_cast<double>(k) + share) / static_cast<double>(materials.size()), "increments");
        });
    } catch (const Interrupted&) {  // the path itself is kept
      kept.emplace();
    }
    run.findings.increments = std::move(accuracy.increments);
    run.findings.iso_error = accuracy.iso_error;
    for (const auto& [name, bytes] : accuracy.files) {
      const std::size_t dot = name.find('.');
      folder.write(name.substr(0, dot) + number + name.substr(dot), bytes);
    }
    if (run.table.rows() > 0) {
      folder.write("path" + number + ".csv", path_csv(run.table));
      folder.write("path" + number + ".npz", path_npz(run.table));
      if (k > 0 && result.own.last.contains("t"))
        run.findings.difference = largest_difference(tables[0].table, run.table);
      tables.push_back({label.empty() ? materials[k].material.name() : label, std::move(run.table)});
    }
    (k == 0 ? result.own : result.variants.emplace_back()) = std::move(run.findings);
    if (kept) break;
  }
  progress.finish();
  result.wall_s = life.seconds();
  if (!tables.empty()) {
    for (const auto& [name, bytes] : path_pictures(scene, tables)) folder.write(name, bytes);
  }
  Scene of_material;
  of_material.material = scene.material;
  leave_replay(of_material, folder, process);
  result.replay = process.replay;
  result.expect = judged_path(scene, result);
  if (!scene.units.is_si()) scene.expect = expected_in_si(scene, tables.empty() ? PathTable() : tables[0].table);
  folder.write("resolved.yaml", resolved_path_yaml(scene));
  const std::string json = path_result_json(result);
  folder.write("result.json", json);
  folder.commit();
  const PathScene& last_stage = scene.later.empty() ? scene : scene.later.back();
  std::string types = scene.type;
  for (const PathScene& stage : scene.later) types += ", then " + stage.type;
  std::string text = wrapped((scene.title.empty() ? "path" : scene.title) + ": " + types, "", "  ");
  text += expected_text(result, false) + findings_text(result.own) + end_text(last_stage, result.own);
  for (const PathFindings& variant : result.variants) text += findings_text(variant) + end_text(last_stage, variant);
  text += expected_text(result, true) + "results in " + one_line(options.out) + "\n";
  const int status = status_of(result);
  if (options.quiet()) text = status == 0 ? "" : expected_text(result, false) + findings_text(result.own);
  tell(text, {{options.json ? "-" : "", json, true}});
  kept.reset();
  stop_if_interrupted();
  return status;
}

}  // namespace assay::drivers
