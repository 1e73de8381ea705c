// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>

#include "drivers/input_error.hpp"
#include "drivers/verb_arguments.hpp"

namespace assay::drivers {

namespace {

Verb recommend_verb(CLI::App& app, Arguments& given) {
  CLI::App& verb = add_verb(app, "recommend", "the cheapest case of a study for an error",
                            "assay recommend results/methods --error 1e-3\n"
                            "  assay recommend study.yaml --error 1%");
  verb.add_option("STUDY", given.study, "results of a study, or its YAML file")->required()->type_name("");
  verb.add_option("--error", given.error, "wanted, in the study's unit or in %")->type_name("NUMBER")->required();
  add_out(verb, given, "DIR", "results of the YAML file (results/STUDY)");
  verb.add_flag("--json", given.json, "as JSON");
  return {&verb, [&given] { return recommend({given.study, given.error, given.out, given.json}); }};
}

Verb compare_verb(CLI::App& app, Arguments& given) {
  CLI::App& verb = add_verb(app, "compare", "two studies: failures, times, errors",
                            "assay compare results/before results/after --markdown difference.md");
  verb.add_option("A", given.study, "results of a study")->required()->type_name("");
  verb.add_option("B", given.after, "those to compare with them")->required()->type_name("");
  verb.add_flag("--json", given.json, "as JSON");
  verb.add_option("--markdown", given.markdown_file, "tables of all cases (- for standard output)")->type_name("FILE");
  return {&verb, [&given] {
            if (given.json && given.markdown_file == "-")
              throw InputError("assay compare: --json and --markdown - both want standard output");
            return compare({given.study, given.after, given.markdown_file, given.json, given.verbosity()});
          }};
}

}  // namespace

std::vector<Verb> study_verbs(CLI::App& app, Arguments& given) {
  return {recommend_verb(app, given), compare_verb(app, given)};
}

}  // namespace assay::drivers
