// SPDX-License-Identifier: BSD-3-Clause
// Models that are right, and the same models each with one planted defect.
#pragma once

#include <string>
#include <vector>

#include "harness/material.hpp"

namespace assay::check_tests {

/// A model and what the battery must say of it.
struct Subject {
  std::string name;
  Material material;
  std::string cause;  ///< of causes::; empty: nothing
};

/// Increments in J2 plasticity with back stress: Hughes-Winget, Green-Naghdi, logarithmic; and their mutants.
std::vector<Subject> incremental_subjects();

/// Total laws (neo-Hookean and others), with tangent and energy; and their mutants.
std::vector<Subject> total_subjects();

}  // namespace assay::check_tests
