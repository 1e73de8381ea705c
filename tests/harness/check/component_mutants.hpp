// SPDX-License-Identifier: BSD-3-Clause
// Slips in single components of a stress, planted in any model.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tests/harness/check/model_table.hpp"
#include "tests/harness/misreporting_material.hpp"

namespace assay::check_tests::component_mutants {

struct Plant {
  const char* name;
  Misreport of;
  const char* cause;
  const char* words;  ///< in the sentence of the diagnosis
};

const std::vector<Plant>& plants();

/// A model with each of them, in their order.
std::vector<Subject> of_model(const assay_material* table, const std::map<std::string, double>& parameters);

}  // namespace assay::check_tests::component_mutants
