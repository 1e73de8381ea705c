// SPDX-License-Identifier: BSD-3-Clause
#include "tests/harness/check/mutants.hpp"

#include <map>
#include <set>
#include <utility>

#include "tests/harness/check/model_table.hpp"

namespace assay::check_tests {

std::vector<Subject> all_subjects() {
  std::vector<Subject> all;
  for (const auto& subjects :
       {incremental_mutants::subjects, total_mutants::subjects, viscous_mutants::subjects, fluid_mutants::subjects,
        soil_mutants::subjects, damage_mutants::subjects, extension_mutants::subjects, fibre_mutants::subjects,
        potential_mutants::subjects, melt_mutants::subjects, crystal_mutants::subjects, hill_mutants::subjects,
        component_mutants::subjects, call_mutants::subjects}) {
    for (Subject& subject : subjects()) all.push_back(std::move(subject));
  }
  return all;
}

std::vector<Subject> few_subjects() {
  constexpr std::size_t most = 2;
  std::vector<Subject> few;
  std::map<std::string, std::set<std::string>> kinds;  // of model, of each cause
  for (Subject& subject : all_subjects()) {
    const std::string kind = subject.material.table().name;
    std::set<std::string>& known = kinds[subject.cause];
    if (!subject.cause.empty() && (known.size() == most || !known.insert(kind).second)) continue;
    few.push_back(std::move(subject));
  }
  return few;
}

check::Report battery_of(const Subject& subject, const check::Options& options) {
  statics = {};
  return check::run_battery(subject.material, options);
}

}  // namespace assay::check_tests
