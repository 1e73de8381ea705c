// SPDX-License-Identifier: BSD-3-Clause
// What the battery has found, as text of 80 columns, JSON and JUnit's XML.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "drivers/verbs.hpp"
#include "harness/check/battery.hpp"

namespace assay::drivers {

struct CheckedMaterial {
  std::string name;     ///< as it was asked for
  std::string library;  ///< empty: built in
  std::vector<std::pair<std::string, double>> parameters;
  check::Report report;
  double wall_s = 0;
};

/// A table of the tests and the diagnosis; every sentence with Verbosity::verbose, the diagnosis alone with quiet.
std::string check_text(const CheckedMaterial& checked, Verbosity verbosity);

/// {material, library, parameters, verdict, diagnosis: [{cause, sentence}], tests: [{id, verdict, measure, threshold,
/// order, cause, sentence}]}; figures that were not found, or are infinite, are null.
std::string check_json(const CheckedMaterial& checked);

/// One test suite; the message of a failure is "cause: sentence".
std::string check_junit(const CheckedMaterial& checked);

/// "pass", "fail", "n/a".
const char* verdict_name(check::Verdict verdict);

}  // namespace assay::drivers
