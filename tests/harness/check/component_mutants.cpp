// SPDX-License-Identifier: BSD-3-Clause
// Built-in models that misreport components of their stress, most of which a motion in the plane 12 does not show.
#include "tests/harness/check/component_mutants.hpp"

#include <utility>

#include "tests/harness/misreporting_material.hpp"

namespace assay::check_tests::component_mutants {

const std::vector<Plant>& plants() {
  using namespace check::causes;
  const auto times = [](int i, int j, double factor) {
    return [=](Tensor& sigma) { sigma(j, i) = sigma(i, j) *= factor; };
  };
  static const std::vector<Plant> all{
      {"13_alone", [](Tensor& sigma) { sigma(0, 2) *= 1.1; }, not_symmetric, "the components 13 and 31 differ"},
      {"13_as_23", [](Tensor& sigma) { sigma = exchanged(sigma); }, components_swapped, "13 and 23"},
      {"23_doubled", times(1, 2, 2), shear_factor, "component 23 of"},
      {"13_halved", times(0, 2, 0.5), shear_factor, "component 13 of"},
      {"13_opposite", times(0, 2, -1), wrong_sign, "component 13 of"},
      {"22_as_33", [](Tensor& sigma) { std::swap(sigma(1, 1), sigma(2, 2)); }, other_order, "components 22 and 33 of"}};
  return all;
}

std::vector<Subject> of_model(const assay_material* table, const std::map<std::string, double>& parameters) {
  std::vector<Subject> all;
  for (const Plant& plant : plants()) {
    const std::string name = std::string(table->name) + "_" + plant.name;
    all.push_back({name, misreporting_material(table, std::string("misreporting_") + table->name, plant.of, parameters),
                   plant.cause});
  }
  return all;
}

std::vector<Subject> subjects() {
  std::vector<Subject> all = of_model(assay_builtin_neo_hookean(ASSAY_ABI_MAJOR, 0), {{"E", 1e3}, {"nu", 0.3}});
  for (Subject& subject : of_model(assay_builtin_j2_jaumann(ASSAY_ABI_MAJOR, 0),
                                   {{"E", 1e3}, {"nu", 0.3}, {"yield_stress", 5}, {"kinematic_modulus", 50}})) {
    all.push_back(std::move(subject));
  }
  return all;
}

}  // namespace assay::check_tests::component_mutants
