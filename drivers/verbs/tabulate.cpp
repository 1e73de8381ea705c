// SPDX-License-Identifier: BSD-3-Clause
// `assay tabulate`: the point driver's sheet tau(xi, t), its slope, and the curve tau(eps).
#include "drivers/verbs/verbs.hpp"

#include <fmt/core.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>

#include "drivers/command_line/verb.hpp"
#include "drivers/findings/findings.hpp"
#include "drivers/output/output_folder.hpp"
#include "drivers/path/path_tabulation.hpp"
#include "drivers/picture/author_units.hpp"
#include "drivers/point_drivers/mtest_run.hpp"
#include "drivers/point_drivers/niemunis_run.hpp"
#include "drivers/result/result_json.hpp"
#include "drivers/scene/expect.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/problem.hpp"
#include "drivers/simulation/response_source.hpp"
#include "drivers/simulation/simulate.hpp"
#include "drivers/simulation/warnings.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/system/terminal.hpp"
#include "drivers/tabulation/tabulation.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/sha256.hpp"
#include "drivers/text/unseen.hpp"
#include "drivers/text/wrapped_text.hpp"
#include "harness/motion/kinds/deformation_table.hpp"

namespace assay::drivers {

namespace {

constexpr const char* belongs_to_paths = "belongs to paths, and this is none";

/// A scene that also runs says in `expect:` what the run should find: of that, the sheet and its
/// references can be judged here.
std::vector<Expectation> expected_here(const Scene& scene) {
  std::vector<Expectation> list;
  for (const Expectation& e : scene.expect) {
    if (!scene.method || e.key.starts_with("sheet.") || e.key.starts_with("reference.")) list.push_back(e);
  }
  return list;
}

std::string summary(const Tabulation& tab, const Result& result, const std::string& folder) {
  std::string text = wrapped(fmt::format("{}: {} on {}, {}", result.title.empty() ? "tabulate" : result.title,
                                         tab.material->name(), tab.path.name, result.outcome),
                             "", "  ");
  text += expectations_text(result, false);
  if (!result.reason.empty()) text += wrapped(result.reason, "  ", "  ");
  text += process_lines(result, folder);
  if (result.sheet) {
    text += sheet_text(*result.sheet);
    text += references_text(result.reference, tab.path.name);
    text += times_text(result, "response");
  }
  return text + expectations_text(result, true) + "results in " + one_line(folder) + "\n";
}

void write_tables(const Tabulation& tab, const std::vector<SheetPoint>& points, const Units& units,
                  OutputFolder& folder) {
  folder.write("sheet.csv", regular_sheet(tab));
  const Curve curve = curve_of(tab);
  folder.write(curve.of_eps ? "curve.csv" : "history.csv", curve_csv(curve));
  const std::string who = tab.material->name() + ", " + tab.path.name;
  const std::string of = curve.of_eps ? "(ε): " : "(t): ", slope = curve.of_eps ? "dτ/dε" : "dτ/dξ";
  folder.write("tau.png", png(in_units(plot_of(curve, curve.tau, "τ", "τ" + of + who), units)));
  folder.write("slope.png", png(in_units(plot_of(curve, curve.slope, slope, slope + of + who), units)));
  folder.write("sheet.png", png(in_units(sheet_picture(tab), units)));
  if (!tab.material->path_independent()) folder.write("histories.png", png(in_units(histories_plot(tab), units)));
  if (!points.empty()) folder.write("points.csv", sheet_at(tab, points));
}

void refuse_of_loading_files(const TabulateOptions& options) {
  if (!options.points.empty())
    throw InputError({}, "--points", "asks for points of a sheet, which such a file has not");
  if (!options.sets.empty()) throw InputError({}, "--set", "changes scenes, and this is none");
  if (is_niemunis(options.scene) && !options.defines.empty())
    throw InputError({}, "--define", "belongs to MTest files");
}

/// The setting of a path's `increments` that "8,16,32" stands for.
std::string setting_of_increments(const std::string& text) {
  std::string list;
  double before = 0;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const auto count = parse_number(text.substr(begin, end - begin));
    if (!count || !(*count > before) || *count > 1e6 || *count != std::floor(*count))
      throw InputError({}, "--increments", "must be whole numbers that ascend, as 8,16,32, found " + shown(text, 80));
    list += (list.empty() ? "" : ", ") + number_text(before = *count);
    begin = end + 1;
  }
  return "increments=[" + list + "]";
}

Act add_tabulate_arguments(VerbArguments& verb) {
  const auto given = std::make_shared<TabulateOptions>();
  add_scene(verb, *given);
  add_value(verb, "--points", given->points, "CSV", "also the response at the xi,t of this file");
  add_value(verb, "--increments", given->increments, "N,N,...", "path: error and order of so many increments");
  add_repeatable(verb, "--define", given->defines, "NAME=VALUE", "MTest file: what stands for @NAME@");
  add_value(verb, "--material", given->material, "MATERIAL", "MTest or loading file: the material to take",
            "@materials");
  add_results(verb, *given);
  return [given](Verbosity verbosity) {
    given->out = results_folder(given->out, given->scene);
    given->verbosity = verbosity;
    return tabulate(*given);
  };
}

}  // namespace

int tabulate(const TabulateOptions& options) {
  forget_inputs();
  const Stopwatch life;
  if (is_same_stream(options.scene, options.points))
    throw InputError({}, "--points", "is the scene's stream, which can be read once");
  if (is_mtest(options.scene) || is_niemunis(options.scene)) {
    refuse_of_loading_files(options);
    if (!options.increments.empty()) throw InputError({}, "--increments", belongs_to_paths);
    if (is_niemunis(options.scene)) return tabulate_niemunis(options, options.material);
    MtestOptions mtest;
    static_cast<SceneOptions&>(mtest) = options;
    mtest.placeholders = placeholders_of(options.defines), mtest.material = options.material;
    return tabulate_mtest(mtest);
  }
  if (!options.defines.empty()) throw InputError({}, "--define", "belongs to MTest files");
  if (!options.material.empty())
    throw InputError({}, "--material", "belongs to MTest and loading files; here --set material.adapter=...");
  const std::string bytes = read_bytes(options.scene);
  if (is_path_text(bytes, options.scene)) {
    if (!options.points.empty()) throw InputError({}, "--points", "asks for points of a sheet, which a path has not");
    std::vector<std::string> sets = options.sets;
    if (!options.increments.empty()) sets.push_back(setting_of_increments(options.increments));
    return tabulate_path(path_tree(bytes, options.scene, sets), sha256_hex(bytes), options);
  }
  if (!options.increments.empty()) throw InputError({}, "--increments", belongs_to_paths);
  Scene scene = scene_from_text(bytes, options.scene, options.sets, to_tabulate);
  std::vector<SheetPoint> points;
  if (!options.points.empty()) points = read_sheet_points(options.points);
  watch_interrupts();
  Tabulation tab;
  std::string library;
  tab.material = material_of(scene, library);
  tab.path = baseline_path(scene);
  tab.end = scene.time.end;
  tab.period = scene.motion->period();
  if (const auto* table = scene.motion.as<DeformationTable>()) tab.last = table->last();
  cover(points, options.points, tab);
  OutputFolder folder(options.out);
  folder.keep_inputs();
  Result result = result_for(scene);
  result.provenance.material = material_provenance(*tab.material, library);
  if (std::string swing = swing_sentence(scene); !swing.empty()) result.warnings.push_back(std::move(swing));
  try {
    warn_of_instability(scene, *tab.material, tab.end, options.quiet());
    result.setup_s = life.seconds();
    if (scene.force.response == ForceChoice::Response::none) scene.force.response = ForceChoice::Response::sheet;
    tab.response = response_of(scene, tab.material, tab.path, tab.end, {.quiet = options.quiet()});
    record_sheet(scene, *tab.response, life.seconds() - result.setup_s, result);
    result.t = tab.end;
    result.reference = references_of(tab.material, tab.path, *tab.response, tab.end);
    result.wall_s = life.seconds() - result.setup_s;
    write_tables(tab, points, scene.units, folder);
  } catch (const MaterialFailure& failure) {
    if (result.wall_s == 0) result.wall_s = life.seconds() - result.setup_s;
    record_failure(failure, result);
  }
  record_process(*tab.material, result);
  leave_replay(scene, folder, result);
  result.peak_rss_bytes = peak_memory();
  close_accounts(life, result);
  result.expect = judge(expected_here(scene), result);
  folder.write("resolved.yaml", resolved_yaml(scene));
  const std::string json = result_json(result);
  folder.write("result.json", json);
  folder.commit();
  tell(said_of(result, options, summary(tab, result, options.out)), {{options.json ? "-" : "", json, true}});
  return exit_status(result);
}

Verb verb_tabulate() {
  return {70, "tabulate a model along a motion, path or MTest file",
          "assay tabulate configs/paper/tabulate_neo_hookean.yaml -o results/sheet", add_tabulate_arguments};
}

}  // namespace assay::drivers
