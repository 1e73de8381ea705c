// SPDX-License-Identifier: BSD-3-Clause
// `assay compare`: what has changed from one study's results to another's.
#include <CLI/CLI.hpp>

#include "drivers/command_line/verb.hpp"
#include "drivers/study/pages/study_pages.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/system/terminal.hpp"

namespace assay::drivers {

namespace {

struct CompareOptions {
  std::string before, after;  ///< folders of results, or their study.json
  std::string markdown;       ///< file; "-": standard output; empty: none
  bool json = false;
  Verbosity verbosity = Verbosity::normal;  ///< verbose: the cases that are the same, too; quiet: the verdict alone
};

int compare(const CompareOptions& options) {
  forget_inputs();
  if (is_same_stream(options.before, options.after))
    throw InputError({}, "assay compare", "A and B are one stream, which can be read once");
  const StoredStudy A = stored_study(options.before), B = stored_study(options.after);
  refuse_input_as_output(options.markdown, "--markdown");
  const Comparison found = compared(A.findings, B.findings);
  const bool whole = options.verbosity == Verbosity::verbose;
  tell(options.verbosity == Verbosity::quiet ? comparison_verdict(found) + "\n" : comparison_text(A, B, found, whole),
       {{options.json ? "-" : "", options.json ? comparison_json(A, B, found) : "", true},
        {options.markdown, options.markdown.empty() ? "" : comparison_markdown(A, B, found)}});
  return found.is_worse() ? 1 : 0;
}

Act add_compare_arguments(VerbArguments& verb) {
  const auto given = std::make_shared<CompareOptions>();
  add_value(verb, "A", given->before, "", "folder of a study's results", "*/ *.json")->required();
  add_value(verb, "B", given->after, "", "results to compare with those of A", "*/ *.json")->required();
  verb.app.add_flag("--json", given->json, "as JSON");
  add_value(verb, "--markdown", given->markdown, "FILE", "write tables of all cases (- for standard output)");
  return [given](Verbosity verbosity) {
    if (given->json && given->markdown == "-")
      throw InputError("assay compare: --json and --markdown - both want standard output");
    given->verbosity = verbosity;
    return compare(*given);
  };
}

}  // namespace

Verb verb_compare() {
  return {120, "compare two studies: failures, times, errors",
          "assay compare results/before results/after --markdown difference.md", add_compare_arguments};
}

}  // namespace assay::drivers
