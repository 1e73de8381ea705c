// SPDX-License-Identifier: BSD-3-Clause
// `assay recommend`: the cheapest measured case of a study that meets an error, or the method that completes most.
#include <CLI/CLI.hpp>

#include "drivers/command_line/verb.hpp"
#include "drivers/study/pages/study_pages.hpp"
#include "drivers/system/terminal.hpp"

namespace assay::drivers {

namespace {

struct RecommendOptions {
  std::string study;  ///< folder of a study's results, its study.json, or the study's YAML file
  /// That is wanted: a number in the study's unit, or "1 %"; without, the method that lives through most is named.
  std::optional<std::string> error;
  std::string out;  ///< folder of the results of a YAML file; empty: results/NAME
  bool json = false;
};

int recommend(const RecommendOptions& options) {
  const StoredStudy study = stored_study(options.study, options.out);
  if (!options.error) {
    const std::vector<Survival> found = survivals(study.findings);
    options.json ? print_json(survival_json(study, found)) : print(survival_text(study, found));
    const Survival* best = hardiest(found);
    return best && best->died == 0 ? 0 : 1;
  }
  const Recommendation found = recommended(study.findings, wanted_error(study.findings, *options.error));
  options.json ? print_json(recommendation_json(study, found)) : print(recommendation_text(study, found));
  return found.best ? 0 : 1;
}

Act add_recommend_arguments(VerbArguments& verb) {
  const auto given = std::make_shared<RecommendOptions>();
  add_value(verb, "STUDY", given->study, "", "folder of a study's results, or its YAML file", "*/ *.yaml *.yml *.json")
      ->required();
  verb.app.add_option("--error", given->error, "wanted error, such as 1e-3 or 1%")->type_name("NUMBER");
  add_out(verb, given->out, "DIR", "results of the YAML file (default: results/STUDY)");
  verb.app.add_flag("--json", given->json, "as JSON");
  return [given](Verbosity) { return recommend(*given); };
}

}  // namespace

Verb verb_recommend() {
  return {110, "the cheapest method for an error, or the most robust",
          "assay recommend results/hard\n"
          "  assay recommend results/methods --error 1e-3\n"
          "  assay recommend study.yaml --error 1%",
          add_recommend_arguments};
}

}  // namespace assay::drivers
