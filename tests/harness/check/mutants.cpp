// SPDX-License-Identifier: BSD-3-Clause
#include "tests/harness/check/mutants.hpp"

#include <utility>

#include "tests/harness/check/model_table.hpp"

namespace assay::check_tests {

std::vector<Subject> all_subjects() {
  std::vector<Subject> all;
  for (const auto& subjects :
       {incremental_subjects, total_subjects, viscous_subjects, fluid_subjects, soil_subjects, damage_subjects,
        extension_subjects, fibre_subjects, potential_subjects, melt_subjects}) {
    for (Subject& subject : subjects()) all.push_back(std::move(subject));
  }
  return all;
}

check::Report battery_of(const Subject& subject, const check::Options& options) {
  statics = {};
  return check::run_battery(subject.material, options);
}

}  // namespace assay::check_tests
