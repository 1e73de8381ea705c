// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/path/path_tabulation.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

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

namespace assay::drivers {

namespace {

using Json = nlohmann::ordered_json;

std::string findings_text(const PathFindings& found) {
  std::string text =
      wrapped((found.label.empty() ? "" : found.label + ": ") + found.material + ", " + found.outcome, "", "  ");
  if (!found.reason.empty()) text += wrapped(found.reason, "  ", "  ");
  for (const std::string& warning : found.warnings) text += wrapped("note: " + warning, "  ", "    ");
  text +=
      wrapped(grouped_text(found.steps) + " steps, " + grouped_text(found.material_calls) +
                  " calls of the model, estimated error " + rounded_text(found.error, 2) + ", residual " +
                  rounded_text(found.residual, 2) + (found.misfit ? ", misfit " + rounded_text(*found.misfit, 3) : ""),
              "  ", "  ");
  for (const IncrementFindings& each : found.increments) {
    text += "  " + grouped_text(each.increments) + " increments: error " + rounded_text(each.error, 2) +
            (each.order ? ", order " + rounded_text(*each.order, 2) : "") + ", " + rounded_text(each.call_ns, 3) +
            " ns a call\n";
  }
  if (!found.iso_error) return text;
  const IsoErrorFindings& map = *found.iso_error;
  return text + wrapped("one increment over the plane of strains: error " + rounded_text(map.mean.value_or(NAN), 2) +
                            " in the mean, " + rounded_text(map.largest.value_or(NAN), 2) + " at most, order " +
                            rounded_text(map.order.value_or(NAN), 2),
                        "  ", "  ");
}

/// The line of the table's end that a user looks at first: what was prescribed.
std::string end_text(const PathScene& scene, const PathFindings& found) {
  std::string text;
  for (const PathRow& row : scene.rows) {
    if (row.origin == PathRow::Origin::held || row.quantity.component().empty()) continue;
    const std::string ij = row.quantity.component();
    const auto add = [&](const std::string& name, const char* unit) {
      const auto at = found.last.find(name);
      if (at != found.last.end())
        text += (text.empty() ? "" : ", ") + name + " = " + rounded_text(at->second, 6) + unit;
    };
    const std::string upper = ij[0] <= ij[1] ? ij : std::string{ij[1], ij[0]};
    add(scene.deformation == Deformation::gradient ? "F" + ij : "e" + upper, "");
    if (row.origin == PathRow::Origin::given) add("s" + upper, " Pa");
  }
  return text.empty() ? text : wrapped("end: t = " + rounded_text(found.t, 6) + " s, " + text, "  ", "  ");
}

std::string expected_text(const PathResult& result, bool that_hold) {
  Result lines;
  lines.expect = result.expect;
  return expectations_text(lines, that_hold);
}

std::vector<ExpectationOutcome> judged_path(const PathScene& scene, const PathResult& result) {
  const auto figures = path_figures(result);
  std::vector<ExpectationOutcome> all;
  for (const Expectation& line : scene.expect) {
    FlatValue value;
    if (line.key == "outcome") value = result.own.outcome;
    const auto found = figures.find(line.key);
    if (found != figures.end()) value = found->second;
    if (found == figures.end() && !result.own.last.empty() &&
        (line.key.starts_with("last.") || line.key.starts_with("largest."))) {
      std::vector<std::string> names;
      for (const auto& [name, last] : result.own.last) names.push_back(name);
      throw InputError(line.where, "expect." + line.key, "is no column of path.csv", joined(names));
    }
    all.push_back(judged(line, value));
  }
  return all;
}

int status_of(const PathResult& result) {
  Result figures;
  figures.expect = result.expect;
  figures.outcome = result.own.outcome == "stopped" ? "completed" : result.own.outcome;
  return exit_status(figures);
}

}  // namespace

std::string path_result_json(const PathResult& result) { return json_document(JsonFields<Json>::of(result)); }

std::map<std::string, double> path_figures(const PathResult& result) {
  std::map<std::string, double> all;
  const auto add = [&](const std::string& prefix, const PathFindings& found) {
    all[prefix + "t"] = found.t;
    all[prefix + "error"] = found.error;
    all[prefix + "residual"] = found.residual;
    all[prefix + "steps"] = static_cast<double>(found.steps);
    all[prefix + "material_calls"] = static_cast<double>(found.material_calls);
    if (found.loses_ellipticity) all[prefix + "loses_ellipticity"] = *found.loses_ellipticity;
    if (found.misfit) all[prefix + "misfit"] = *found.misfit;
    if (!found.increments.empty()) {
      const IncrementFindings& finest = found.increments.back();
      all[prefix + "finest.error"] = finest.error;
      if (finest.order) all[prefix + "finest.order"] = *finest.order;
    }
    if (found.iso_error) {
      all[prefix + "iso_error.largest"] = *found.iso_error->largest;
      all[prefix + "iso_error.mean"] = *found.iso_error->mean;
      all[prefix + "iso_error.order"] = *found.iso_error->order;
    }
    for (const auto& [name, value] : found.last) all[prefix + "last." + name] = value;
    for (const auto& [name, value] : found.largest) all[prefix + "largest." + name] = value;
  };
  add("", result.own);
  return all;
}

std::vector<std::string> path_figure_keys(const Tree& expect) {
  std::vector<std::string> keys{"t",
                                "error",
                                "residual",
                                "steps",
                                "material_calls",
                                "loses_ellipticity",
                                "misfit",
                                "finest.error",
                                "finest.order",
                                "iso_error.largest",
                                "iso_error.mean",
                                "iso_error.order"};
  for (const Tree::Entry& entry : expect.entries) {
    if (entry.key.starts_with("last.") || entry.key.starts_with("largest.")) keys.push_back(entry.key);
  }
  return keys;
}

const std::vector<std::string>& path_outcomes() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const char* name : names_of(ControlOutcome())) all.emplace_back(name);
    return all;
  }();
  return names;
}

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
  materials.push_back(resolve_material(scene.material));
  scene.material = materials[0].choice;
  for (PathVariant& variant : scene.variants) {
    materials.push_back(resolve_material(variant.material));
    variant.material = materials.back().choice;
  }
  for (const ResolvedMaterial& material : materials) {
    for (const std::string& sentence : material.warnings) warn(sentence);
  }
  OutputFolder folder(options.out);
  folder.keep_inputs();
  PathResult result;
  result.title = scene.title;
  result.provenance = build_information();
  result.provenance.scene_sha256 = sha256;
  result.provenance.material = material_provenance(materials[0].material, materials[0].library);
  std::vector<NamedTable> tables;
  Progress progress("path", options.quiet());
  Result process;  // what the model has done to its own
  for (std::size_t k = 0; k < materials.size(); ++k) {
    const std::string label = k == 0 ? "" : scene.variants[k - 1].label;
    PathRun run = run_path(scene, materials[k].material, [&](double share) {
      progress.update((static_cast<double>(k) + share) / static_cast<double>(materials.size()));
    });
    run.findings.label = label;
    if (k == 0) {
      run.findings.warnings.insert(run.findings.warnings.begin(), scene.warnings.begin(), scene.warnings.end());
      record_process(materials[0].material, process);
      for (const std::string& warning : process.warnings) run.findings.warnings.push_back(warning);
      if (run.failure && run.failure->step)
        process.failed_step = std::make_shared<const FailedStep>(*run.failure->step);
      process.reason = run.findings.reason;
    }
    const std::string number = k == 0 ? "" : "_" + std::to_string(k);
    PathAccuracy accuracy = path_accuracy(scene, materials[k].material, label, [&](double share) {
      progress.update((static_cast<double>(k) + share) / static_cast<double>(materials.size()), "increments");
    });
    run.findings.increments = std::move(accuracy.increments);
    run.findings.iso_error = accuracy.iso_error;
    for (const auto& [name, bytes] : accuracy.files) {
      const std::size_t dot = name.find('.');
      folder.write(name.substr(0, dot) + number + name.substr(dot), bytes);
    }
    if (run.table.rows() > 0) {
      folder.write("path" + number + ".csv", path_csv(run.table));
      folder.write("path" + number + ".npz", path_npz(run.table));
      tables.push_back({label.empty() ? materials[k].material.name() : label, std::move(run.table)});
    }
    (k == 0 ? result.own : result.variants.emplace_back()) = std::move(run.findings);
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
  folder.write("resolved.yaml", resolved_path_yaml(scene));
  const std::string json = path_result_json(result);
  folder.write("result.json", json);
  folder.commit();
  std::string text = wrapped((scene.title.empty() ? "path" : scene.title) + ": " + scene.type, "", "  ");
  text += expected_text(result, false) + findings_text(result.own) + end_text(scene, result.own);
  for (const PathFindings& variant : result.variants) text += findings_text(variant) + end_text(scene, variant);
  text += expected_text(result, true) + "results in " + one_line(options.out) + "\n";
  const int status = status_of(result);
  if (options.quiet()) text = status == 0 ? "" : expected_text(result, false) + findings_text(result.own);
  tell(text, {{options.json ? "-" : "", json, true}});
  return status;
}

}  // namespace assay::drivers
