// SPDX-License-Identifier: BSD-3-Clause
// What the patch tests have found, as text of 80 columns, JSON and JUnit's XML.
#pragma once

#include <string>
#include <vector>

#include "drivers/system/terminal.hpp"
#include "mpm/patch/patch.hpp"

namespace assay::drivers {

struct CheckedMethods {
  std::vector<mpm::MethodReport> methods;
  double wall_s = 0;
  int dimension = 2;
  bool passes() const;
};

/// The verdict; what fails, with its sentence; counts for each basis and formulation; why something is not promised.
/// For one method, and with Verbosity::verbose, the rows of all tests; with quiet the verdict alone.
std::string methods_text(const CheckedMethods& checked, Verbosity verbosity);

/// {methods, verdict, tests: [{method, basis, formulation, transfer, update, mass, id, verdict, measure, threshold,
/// order, cause, sentence}]}, in space with dimension: 3; figures that were not found, or are infinite, are null.
std::string methods_json(const CheckedMethods& checked);

/// One test suite, in space "assay check methods_3d"; a test case is named "cpdi/flip/usl translation".
std::string methods_junit(const CheckedMethods& checked, const std::string& name = {});

/// The tests that all methods pass by name, then one row for methods that agree in all others and one column for tests
/// that agree in all rows. A row holds every transfer that it names, with every basis and formulation that it names.
std::string methods_markdown(const CheckedMethods& checked);

}  // namespace assay::drivers
