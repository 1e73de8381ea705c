// SPDX-License-Identifier: BSD-3-Clause
// Every built-in model with sets of parameters and amplitudes, and its Cauchy stress by equations that are typed apart
// from the model.
#pragma once

#include <iosfwd>

#include "tests/adapters/models/histories.hpp"

namespace assay::model_tests {

struct ModelCase {
  std::string name;  ///< of the model and the set
  std::string model;
  Parameters parameters;
  double peak;                                   ///< of the vortex's amplitude g
  std::function<Tensor(const History&)> stress;  ///< Cauchy stress at the end of a history [Pa]

  Material material() const { return material_of(model, parameters); }
  bool smooth() const { return !material().has(ASSAY_NON_SMOOTH); }
};

std::ostream& operator<<(std::ostream& out, const ModelCase& c);

/// Models whose sheets take a fraction of a second.
std::vector<ModelCase> quick_model_cases();
std::vector<ModelCase> all_model_cases();

}  // namespace assay::model_tests
