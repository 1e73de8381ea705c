// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/point_drivers/mtest_run.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "drivers/findings/findings.hpp"
#include "drivers/format/csv.hpp"
#include "drivers/material/material_choice.hpp"
#include "drivers/output/output_folder.hpp"
#include "drivers/path/path_result.hpp"
#include "drivers/point_drivers/mtest_control.hpp"
#include "drivers/point_drivers/mtest_fields.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/sha256.hpp"
#include "drivers/text/words.hpp"
#include "drivers/text/wrapped_text.hpp"

namespace assay::drivers {

namespace {

/// TFEL's names beside ours.
const std::map<std::string, std::string>& our_names() {
  static const std::map<std::string, std::string> names{{"YoungModulus", "E"}, {"PoissonRatio", "nu"}};
  return names;
}

/// 'MFrontLaw' as a loader finds it: libMFrontLaw.so.
std::string library_file(const MtestFile& file) {
  std::filesystem::path path(file.behaviour.library);
  if (path.extension() != ".so") path += ".so";
  if (!path.has_parent_path() && !path.string().starts_with("lib")) path = "lib" + path.string();
  return path.has_parent_path() ? mtest_path(file.file, path.string()) : path.string();
}

MaterialChoice material_of(const MtestFile& file, const std::string& instead) {
  MaterialChoice choice;
  choice.where = file.behaviour.where;
  choice.adapter_key = "@Behaviour", choice.parameters_key = "@MaterialProperty";
  choice.needs_density = false;
  choice.adapter = instead.empty() ? library_file(file) + ":" + file.behaviour.function : instead;
  for (const MtestProperty& property : file.properties) {
    const auto ours = our_names().find(property.name);
    const std::string name = instead.empty() || ours == our_names().end() ? property.name : ours->second;
    if (name == "MassDensity" || name.find("ThermalExpansion") != name.npos) continue;
    choice.parameters[name] = property.value(file.times[0]);
    choice.parameter_where[name] = choice.parameter_key_where[name] = property.where;
  }
  for (const MtestParameter& parameter : file.parameters) {
    choice.parameters[parameter.name] = parameter.value;
    choice.parameter_where[parameter.name] = choice.parameter_key_where[parameter.name] = parameter.where;
  }
  return choice;
}

struct Comparison {
  std::string variable;
  double tolerance = 0, difference = 0, t = 0;  ///< the largest, and when
  bool holds() const { return difference <= tolerance; }
};

Comparison compared(const MtestFile& file, const MtestComparison& asked, const Material& material,
                    const ControlledHistory& history) {
  Comparison found{asked.variable, asked.tolerance, 0, 0};
  const std::vector<double> lines = asked.expected ? std::vector<double>() : expected_lines(file, asked);
  for (const ControlledRow& row : history.rows) {
    const auto at = std::find(file.times.begin(), file.times.end(), row.t);
    if (at == file.times.begin() || at == file.times.end()) continue;
    const auto value = mtest_value(file, material, asked.variable, row);
    if (!value) throw InputError(asked.where, "@Test", "nothing is called '" + asked.variable + "'");
    const auto line = static_cast<std::size_t>(at - file.times.begin());
    if (!asked.expected && line >= lines.size())
      throw InputError(asked.where, "@Test", "the file ends before t = " + number_text(row.t));
    const double difference = std::abs(*value - (asked.expected ? asked.expected(row.t) : lines[line]));
    if (!(difference <= found.difference)) found.difference = difference, found.t = row.t;
  }
  return found;
}

std::string comparisons_text(const std::vector<Comparison>& all, bool that_hold) {
  std::string text;
  for (const Comparison& each : all) {
    if (each.holds() != that_hold) continue;
    text += std::string(that_hold ? "holds " : "FAILS ") + each.variable + ": largest difference " +
            rounded_text(each.difference, 3) + " at t = " + rounded_text(each.t, 4) + ", tolerance " +
            rounded_text(each.tolerance, 3) + "\n";
  }
  return text;
}

std::string comparisons_csv(const std::vector<Comparison>& all) {
  CsvText csv({"variable", "largest_difference", "t", "tolerance", "holds"});
  for (const Comparison& each : all)
    csv.row(std::vector<std::string>{each.variable, number_text(each.difference), number_text(each.t),
                                     number_text(each.tolerance), each.holds() ? "1" : "0"});
  return csv.text();
}

}  // namespace

bool is_mtest(const std::string& file) { return file.ends_with(".mtest") || file.ends_with(".mtest.in"); }

std::map<std::string, std::string> placeholders_of(const std::vector<std::string>& defines) {
  std::map<std::string, std::string> all;
  for (const std::string& define : defines) {
    const std::size_t equals = define.find('=');
    if (equals == define.npos || equals == 0)
      throw InputError({}, "--define", "write NAME=VALUE, found '" + one_line(define, 80) + "'");
    all[define.substr(0, equals)] = define.substr(equals + 1);
  }
  return all;
}

int tabulate_mtest(const MtestOptions& options) {
  const Stopwatch life;
  const std::string text = read_bytes(options.scene);
  const MtestFile file = mtest_from_text(text, options.scene, {options.placeholders, {}});
  MaterialChoice choice = material_of(file, options.material);
  const MtestFields fields = mtest_fields(file, choice);
  ResolvedMaterial material = resolve_material(choice);
  material.material.prescribe(fields.values, file.times.front());
  refuse_plane_stress(material, "--material", "a file of MTest is of three dimensions here");
  const Control control = mtest_control(file, material.material);
  watch_interrupts();
  ControlOptions how{.increments = 1, .watch_ellipticity = false};
  how.progress = [](double) { stop_if_interrupted(); };
  OutputFolder folder(options.out);
  folder.keep_inputs();
  PathResult result;
  result.title = std::filesystem::path(file.file).stem().string();
  result.provenance = build_information();
  result.provenance.scene_sha256 = sha256_hex(text);
  result.provenance.material = material_provenance(material.material, material.library);
  ControlledHistory history;
  try {
    history = follow_control(material.material, control, file.times, how);
  } catch (const ControlError& error) {
    throw InputError({file.file, 0, 0}, "", error.what());
  }
  PathFindings& found = result.own;
  found.material = material.material.name();
  found.outcome = names_of(history.outcome)[static_cast<std::size_t>(history.outcome)];
  found.t = history.rows.back().t;
  if (history.outcome != ControlOutcome::completed)
    found.reason = history.reason + " at t = " + rounded_text(found.t, 6);
  found.steps = history.steps, found.material_calls = history.calls;
  for (const MtestIgnored& ignored : file.ignored)
    found.warnings.push_back(ignored.keyword + " has no effect here: " + ignored.what);
  found.warnings.insert(found.warnings.end(), fields.notes.begin(), fields.notes.end());
  std::vector<Comparison> comparisons;
  for (const MtestComparison& asked : file.comparisons)
    comparisons.push_back(compared(file, asked, material.material, history));
  const bool all_hold = std::ranges::all_of(comparisons, &Comparison::holds);
  const int status = history.outcome == ControlOutcome::completed && all_hold ? 0 : 1;
  result.wall_s = life.seconds();
  folder.write("path.csv", path_csv(path_table(material.material, history, control)));
  folder.write("comparisons.csv", comparisons_csv(comparisons));
  const std::string json = path_result_json(result);
  folder.write("result.json", json);
  folder.commit();
  std::string said = wrapped(result.title + ": " + found.material + ", " + found.outcome, "", "  ");
  if (!found.reason.empty()) said += wrapped(found.reason, "  ", "  ");
  said += comparisons_text(comparisons, false);
  if (!options.quiet()) {
    for (const std::string& warning : found.warnings) said += wrapped("note: " + warning, "  ", "    ");
    said += comparisons_text(comparisons, true) + "results in " + one_line(options.out) + "\n";
  }
  if (options.quiet() && status == 0) said.clear();
  tell(said, {{options.json ? "-" : "", json, true}});
  return status;
}

}  // namespace assay::drivers
