// SPDX-License-Identifier: BSD-3-Clause
// `assay recommend`: the cheapest measured case of a study that meets an error, or the method that completes most.

#include "drivers/output/terminal.hpp"
#include "drivers/study/recommendation.hpp"
#include "drivers/study/survival.hpp"
#include "drivers/verbs.hpp"

namespace assay::drivers {

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

}  // namespace assay::drivers
