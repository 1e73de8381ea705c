// SPDX-License-Identifier: BSD-3-Clause
// `assay recommend`: the cheapest measured case of a study that meets an error, or the method that completes most.
#include <iostream>

#include "drivers/study/recommendation.hpp"
#include "drivers/study/survival.hpp"
#include "drivers/verbs.hpp"

namespace assay::drivers {

int recommend(const RecommendOptions& options) {
  const StoredStudy study = stored_study(options.study, options.out);
  if (!options.error) {
    const std::vector<Survival> found = survivals(study.findings);
    std::cout << (options.json ? survival_json(study, found) : survival_text(study, found));
    const Survival* best = hardiest(found);
    return best && best->died == 0 ? 0 : 1;
  }
  const Recommendation found = recommended(study.findings, wanted_error(study.findings, *options.error));
  std::cout << (options.json ? recommendation_json(study, found) : recommendation_text(study, found));
  return found.best ? 0 : 1;
}

}  // namespace assay::drivers
