// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/export/deck_law.hpp"

#include <algorithm>

#include "drivers/export/mesh_text.hpp"
#include "drivers/text/unseen.hpp"

namespace assay::drivers {

namespace {

/// Eight constants a line.
std::string user_material(const Material& material, const Scene& scene) {
  const assay_material& table = material.table();
  std::string constants;
  for (std::uint32_t k = 0; k < table.parameter_count; ++k) {
    const auto given = scene.material.parameters.find(table.parameters[k].name);
    constants += deck_number(given == scene.material.parameters.end() ? 0 : given->second);
    constants += k + 1 == table.parameter_count ? "\n" : k % 8 == 7 ? ",\n" : ", ";
  }
  std::size_t states = 0;
  for (std::uint32_t k = 0; k < table.state_count; ++k) {
    const auto kind = table.state[k].kind;
    states += kind == ASSAY_SCALAR ? 1 : kind == ASSAY_VECTOR ? 3 : kind == ASSAY_SYMMETRIC_TENSOR ? 6 : 9;
  }
  std::string text = "*USER MATERIAL, CONSTANTS=" + std::to_string(table.parameter_count) + "\n" + constants;
  if (states > 0) text += "*DEPVAR\n" + std::to_string(states) + "\n";
  return text;
}

}  // namespace

DeckLaws deck_laws(const ExportedProblem& problem) {
  const std::string& name = problem.scene.material.adapter;
  const std::string of_user = user_material(*problem.material, problem.scene);
  const auto value = [&](const char* parameter) { return problem.scene.material.parameters.at(parameter); };
  if (name == "neo_hookean") {
    const std::string mu = deck_number(value("E") / (2 * (1 + value("nu")))), nu = deck_number(value("nu"));
    return {{"SOLID", "*HYPERFOAM, N=1\n" + mu + ", 2., " + nu + "\n"},
            {"CIARLET_EL", of_user},
            "The material is `*HYPERFOAM` with alpha = 2 for Abaqus, and the user material `CIARLET_EL` that CalculiX "
            "contains. Where the volume stays, as in the exact motion, their stress is that of the scene's neo-Hookean "
            "material."};
  }
  if (name == "mooney_rivlin") {
    const DeckLaw both{"SOLID", "*HYPERELASTIC, MOONEY-RIVLIN\n" + deck_number(value("c10")) + ", " +
                                    deck_number(value("c01")) + ", " + deck_number(2 / value("bulk_modulus")) + "\n"};
    return {
        both, both,
        "The material is `*HYPERELASTIC, MOONEY-RIVLIN`. Where the volume stays, as in the exact motion, its stress "
        "is that of the scene's material."};
  }
  const std::string umat = " Run Abaqus with `user=` and your UMAT, which gets the parameters of the scene's material.";
  if (name == "saint_venant_kirchhoff") {
    return {{"SOLID", of_user},
            {"SOLID", "*ELASTIC\n" + deck_number(value("E")) + ", " + deck_number(value("nu")) + "\n"},
            "The material is `*ELASTIC` for CalculiX, which with `NLGEOM` is the law of Saint Venant and Kirchhoff. "
            "Abaqus takes `*ELASTIC` for another law, and its deck has `*USER MATERIAL`." +
                umat};
  }
  return {{"SOLID", of_user},
          {"SOLID", of_user},
          "The material is `*USER MATERIAL` with the parameters of `" + shown(name, 80) +
              "` in their order: neither code has it." + umat +
              " Correct `*DEPVAR` if your UMAT counts its variables otherwise. CalculiX must be compiled with it."};
}

}  // namespace assay::drivers
