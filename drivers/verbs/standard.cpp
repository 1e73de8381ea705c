// SPDX-License-Identifier: BSD-3-Clause
// `assay standard`: the standard set, run by our methods or judged from the results of other codes.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <map>

#include "drivers/command_line/verb.hpp"
#include "drivers/export/export.hpp"
#include "drivers/output/output_folder.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/standard/standard_runs.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/system/terminal.hpp"
#include "drivers/system/whole_file.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/wrapped_text.hpp"
#include "drivers/verbs/verbs.hpp"

namespace assay::drivers {

namespace {

namespace fs = std::filesystem;

std::string list_text(const StandardSet& set) {
  std::string text = set.title + "\n" + padded("  problem", 32) + padded("grids h [m]", 24) + "title\n";
  for (const StandardProblem& problem : set.problems) {
    std::string grids;
    for (const double h : problem.grids) grids += (grids.empty() ? "" : ", ") + rounded_text(h, 4);
    text += wrapped(problem.scene().title, padded("  " + problem.id, 32) + padded(grids, 24), std::string(56, ' '));
  }
  return text;
}

/// Writes a folder for each problem that the target can express.
int export_set(const StandardSet& set, const StandardOptions& options) {
  if (options.target.empty()) throw InputError({}, "--to", "export needs a target", "those of `assay export --help`");
  target_of(options.target);
  std::map<std::string, std::string> left_out;  // problems by the reason
  std::size_t written = 0;
  for (const StandardProblem& problem : set.problems) {
    ExportOptions one;
    const fs::path scenes = fs::path(options.out) / "scenes";
    fs::create_directories(scenes);
    one.scene = (scenes / problem.file()).string();
    write_file(one.scene, problem.text);
    for (const double h : problem.grids) one.grids += (one.grids.empty() ? "" : ",") + number_text(h);
    one.target = options.target, one.out = (fs::path(options.out) / problem.id).string();
    one.verbosity = Verbosity::quiet;
    try {
      const int status = export_scene(one);
      if (status != 0) return status;
      ++written;
    } catch (const InputError& refusal) {
      std::string reason = refusal.what();
      if (const std::size_t at = reason.find(one.scene); at != reason.npos) reason.erase(at, one.scene.size() + 1);
      std::string& ids = left_out[reason];
      ids += (ids.empty() ? "" : ", ") + problem.id;
    }
  }
  std::string text;
  for (const auto& [reason, ids] : left_out) text += wrapped("left out: " + ids + ": " + reason, "", "  ");
  if (!options.quiet)
    print(text + std::to_string(written) + " of " + std::to_string(set.problems.size()) + " problems written to " +
          options.out + (written > 0 ? ", begin with the README.md of each\n" : "\n"));
  return written > 0 ? 0 : 2;
}

/// Writes card.json, card.md and card.html.
int leave_card(const StandardCard& card, const StandardOptions& options) {
  OutputFolder folder(options.out, {"card.json", "card.md", "card.html"});
  const std::string json = card_json(card);
  folder.write("card.md", card_markdown(card));
  folder.write("card.html", card_html(card));
  folder.write("card.json", json);
  folder.commit();
  bool good = true;
  for (const CardCode& code : card.codes) good = good && code.passed() == code.run();
  const std::string text =
      options.quiet && good ? "" : card_text(card) + "card in " + (fs::path(options.out) / "card.html").string() + "\n";
  tell(text, {{options.json ? "-" : "", json, true}, {options.markdown, card_markdown(card)}});
  return good ? 0 : 1;
}

Act add_standard_arguments(VerbArguments& verb) {
  const auto given = std::make_shared<StandardOptions>();
  const auto only = std::make_shared<std::string>(), edition = std::make_shared<std::string>();
  verb.app.add_option("ACTION", given->action, "list, run (default), export or judge")
      ->type_name("")
      ->check(CLI::IsMember({"list", "run", "export", "judge"}).description(""));
  verb.app.add_option("FOLDER", given->folders, "of judge: results of a code")->expected(0, -1)->type_name("");
  add_value(verb, "--only", *only, "ID,...", "these problems alone");
  add_value(verb, "--to", given->target, "TARGET", "of export: code or format to write for");
  add_value(verb, "--edition", *edition, "N", "edition of the set (default: the latest)");
  add_value(verb, "-o", given->out, "DIR", "folder for the results (default: results/standard)");
  add_value(verb, "--markdown", given->markdown, "FILE", "the card as Markdown (- for standard output)");
  verb.app.add_flag("--json", given->json, "print card.json instead of text");
  return [given, only, edition](Verbosity verbosity) {
    given->quiet = verbosity == Verbosity::quiet;
    if (!only->empty()) {
      for (const std::string& id : split(*only, ',')) given->only.emplace_back(stripped(id));
    }
    if (!edition->empty()) {
      const auto number = parse_integer(*edition);
      if (!number) throw InputError({}, "--edition", "'" + *edition + "' is no whole number");
      given->edition = static_cast<int>(std::clamp<std::int64_t>(*number, 0, 1000000));
    }
    return standard(*given);
  };
}

}  // namespace

int standard(const StandardOptions& options) {
  forget_inputs();
  const StandardSet set = standard_set(options.edition, options.only);
  if (options.action == "list") {
    print(list_text(set));
    return 0;
  }
  watch_interrupts();
  if (options.action == "export") return export_set(set, options);
  StandardCard card{.title = set.title, .edition = set.edition, .codes = {}, .provenance = build_information()};
  if (options.action == "judge") {
    if (options.folders.empty()) throw InputError({}, "FOLDER", "judge needs folders with results");
    for (const std::string& folder : options.folders) {
      const std::string name = fs::path(folder).lexically_normal().filename().string();
      card.codes.push_back(judged_code(set, folder, (fs::path(options.out) / name).string(), options.quiet));
    }
  } else {
    for (const StandardMethod& method : set.methods)
      card.codes.push_back(run_by(set, method, options.out, options.quiet, options.program));
  }
  return leave_card(card, options);
}

Verb verb_standard() {
  return {87, "run or judge the standard set of problems",
          "assay standard\n  assay standard judge results/my_code -o results/card", add_standard_arguments};
}

}  // namespace assay::drivers
