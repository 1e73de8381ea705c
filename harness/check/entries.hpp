// SPDX-License-Identifier: BSD-3-Clause
// The list of the battery's tests, in their order.
#pragma once

#include <functional>
#include <vector>

#include "harness/check/diagnosis.hpp"
#include "harness/check/specimen.hpp"

namespace assay::check {

/// One test of the list.
struct Entry {
  const char* id;
  const char* cause_of_failure;  ///< where the material refuses a step; null: that it does
  std::function<TestResult(const Specimen&, Evidence&)> run;
  bool decides = false;  ///< where it fails, no later test can be judged
};

/// Whether results mean anything: to be taken first.
std::vector<Entry> first_entries();

std::vector<Entry> entries();

}  // namespace assay::check
