// SPDX-License-Identifier: BSD-3-Clause
// The verbs of studies and what they take.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <thread>

#include "drivers/input_error.hpp"
#include "drivers/output/numbers.hpp"
#include "drivers/scene/number_slips.hpp"
#include "drivers/verb_arguments.hpp"

namespace assay::drivers {

namespace {

int jobs_of(const std::string& text) {
  if (text.empty()) return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const auto count = parse_integer(text);
  if (!count || *count < 1 || *count > 4096)
    throw InputError({}, "--jobs",
                     "must be a whole number from 1 to 4096, found '" + one_line(text, 60) + "'" + number_remedy(text));
  return static_cast<int>(*count);
}

Shard shard_of(const std::string& text) {
  if (text.empty()) return {};
  const std::size_t slash = text.find('/');
  const std::string after = slash == text.npos ? "" : text.substr(slash + 1);
  const std::int64_t index = parse_integer(text.substr(0, slash)).value_or(0), count = parse_integer(after).value_or(0);
  if (index < 1 || count < index || count > 100000)
    throw InputError({}, "--shard", "must be i/n with i from 1 to n, found '" + one_line(text, 60) + "'");
  return {static_cast<std::size_t>(index), static_cast<std::size_t>(count)};
}

StudyOptions study_options(const Arguments& given) {
  const bool runs = !given.merge && !given.list;
  if (given.merge && given.list) throw InputError("assay study: --merge and --list exclude each other");
  if (!runs && (given.resume || !given.shard.empty()))
    throw InputError("assay study: --merge and --list run nothing: they take no --resume and no --shard");
  if (!given.from.empty() && !given.merge) throw InputError("assay study: --from goes with --merge");
  StudyOptions options;
  options.study = given.study;
  options.out = given.study_folder();
  options.jobs = jobs_of(given.jobs);
  options.shard = shard_of(given.shard);
  options.resume = given.resume, options.merge = given.merge, options.from = given.from;
  options.list = given.list, options.json = given.json, options.verbosity = given.verbosity();
  return options;
}

Verb study_verb(CLI::App& app, Arguments& given) {
  CLI::App& verb = add_verb(app, "study", "run a scene over methods and grids: error and cost",
                            "assay study configs/studies/quick.yaml -o results/quick\n"
                            "  assay study big.yaml --shard 2/8 -o /shared/big\n"
                            "  assay study big.yaml --merge -o /shared/big");
  verb.add_option("STUDY", given.study, "YAML file of the study")->required()->type_name("");
  verb.add_option("--jobs", given.jobs, "untimed cases at the same time (default: all cores)")->type_name("N");
  verb.add_flag("--resume", given.resume, "keep finished cases of an earlier run");
  verb.add_option("--shard", given.shard, "run part i of n; --merge writes the report later")->type_name("i/n");
  verb.add_flag("--merge", given.merge, "run nothing, report on the finished cases");
  verb.add_option("--from", given.from, "with --merge: cases of this folder too; repeatable")
      ->type_name("DIR")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->allow_extra_args(false);
  verb.add_flag("--list", given.list, "list the cases and run nothing");
  add_out(verb, given, "DIR", "folder for the results (default: results/STUDY)");
  verb.add_flag("--json", given.json, "print JSON instead of text");
  return {&verb, [&given] { return study(study_options(given)); }};
}

Verb recommend_verb(CLI::App& app, Arguments& given) {
  CLI::App& verb = add_verb(app, "recommend", "the cheapest method for an error, or the most robust",
                            "assay recommend results/hard\n"
                            "  assay recommend results/methods --error 1e-3\n"
                            "  assay recommend study.yaml --error 1%");
  verb.add_option("STUDY", given.study, "folder of a study's results, or its YAML file")->required()->type_name("");
  verb.add_option("--error", given.error, "wanted error, such as 1e-3 or 1%")->type_name("NUMBER");
  add_out(verb, given, "DIR", "results of the YAML file (default: results/STUDY)");
  verb.add_flag("--json", given.json, "as JSON");
  return {&verb, [&given] { return recommend({given.study, given.error, given.out, given.json}); }};
}

Verb compare_verb(CLI::App& app, Arguments& given) {
  CLI::App& verb = add_verb(app, "compare", "compare two studies: failures, times, errors",
                            "assay compare results/before results/after --markdown difference.md");
  verb.add_option("A", given.study, "folder of a study's results")->required()->type_name("");
  verb.add_option("B", given.after, "results to compare with those of A")->required()->type_name("");
  verb.add_flag("--json", given.json, "as JSON");
  verb.add_option("--markdown", given.markdown_file, "write tables of all cases (- for standard output)")
      ->type_name("FILE");
  return {&verb, [&given] {
            if (given.json && given.markdown_file == "-")
              throw InputError("assay compare: --json and --markdown - both want standard output");
            return compare({given.study, given.after, given.markdown_file, given.json, given.verbosity()});
          }};
}

}  // namespace

std::vector<Verb> study_verbs(CLI::App& app, Arguments& given) {
  return {study_verb(app, given), recommend_verb(app, given), compare_verb(app, given)};
}

}  // namespace assay::drivers
