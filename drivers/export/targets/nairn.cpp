// SPDX-License-Identifier: BSD-3-Clause
// For NairnMPM: material points in the plane vortex, with the body force as functions at the nodes.
#include "drivers/export/exported_force.hpp"
#include "drivers/export/force_expressions.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/unseen.hpp"

namespace assay::drivers {

namespace {

constexpr double nairn_courant = 0.4;  ///< of the code's own default, 0.5, which it does not exceed
constexpr int nairn_margin = 2;        ///< cells of the grid around the body

std::string nairn_material(const Scene& scene, double density) {
  const std::string& name = scene.material.adapter;
  const std::string rho = "    <rho>" + number_text(density) + "</rho>\n";
  if (name != "neo_hookean")
    return "  <!-- YOURS: the stress of " + shown(name, 60) + " -->\n  <Material Type='YOURS' Name='solid'>\n" + rho +
           "  </Material>";
  // (K/2) (ln J)^2 with Lame's constant for K, as the scene has it
  return "  <Material Type='28' Name='solid'>\n" + rho + "    <E>" + number_text(scene.material.parameters.at("E")) +
         "</E>\n    <nu>" + number_text(scene.material.parameters.at("nu")) +
         "</nu>\n    <UJOption>2</UJOption>\n  </Material>";
}

Deck nairn_deck(const ExportedProblem& problem) {
  Deck deck;
  const ForcePieces pieces = exported_pieces(problem, "nairn");
  const NairnFunctions functions = nairn_force(pieces);
  std::string commands, folders;
  for (const ExportedGrid& grid : problem.grids) {
    const ExportedSteps steps = steps_of_outputs(problem, grid.h, nairn_courant);
    const double margin = nairn_margin * grid.h;
    deck.files[grid.folder + "/input.xml"] = filled_template(
        "nairn", "input.xml",
        {{"STEP", number_text(steps.step)},
         {"END", number_text(problem.end)},
         {"OUTPUT", number_text(problem.end / exported_outputs)},
         {"GRID_LOWER_X", number_text(grid.lower[0] - margin)},
         {"GRID_UPPER_X", number_text(grid.upper[0] + margin)},
         {"GRID_LOWER_Y", number_text(grid.lower[1] - margin)},
         {"GRID_UPPER_Y", number_text(grid.upper[1] + margin)},
         {"LOWER_X", number_text(grid.lower[0])},
         {"UPPER_X", number_text(grid.upper[0])},
         {"LOWER_Y", number_text(grid.lower[1])},
         {"UPPER_Y", number_text(grid.upper[1])},
         {"SPACING", number_text(grid.h)},
         {"VELOCITY", "      <vel0X>" + functions.v[0] + "</vel0X>\n      <vel0Y>" + functions.v[1] + "</vel0Y>\n"},
         {"MATERIAL", nairn_material(problem.scene, problem.density)},
         {"FORCE_X", functions.b[0]},
         {"FORCE_Y", functions.b[1]}});
    deck.runs.push_back(grid.folder + "/out.csv");
    commands += "(cd " + grid.folder + " && NairnMPM input.xml)\n";
    folders += (folders.empty() ? "" : " ") + grid.folder;
  }
  deck.files["to_csv.py"] = filled_template("nairn", "to_csv.py");
  const bool own = problem.scene.material.adapter == "neo_hookean";
  deck.readme = filled_template(
      "nairn", "README.md",
      {{"COMMANDS", commands},
       {"FOLDERS", folders},
       {"PIECES", pieces_words(pieces)},
       {"MATERIAL_WORDS", own ? "The material is type 28, `Neohookean` with `UJOption` 2, which is that of the scene."
                              : "The deck lacks the material: write one with the stress of `" +
                                    shown(problem.scene.material.adapter, 60) + "` at the marked place."}});
  deck.map = filled_template("nairn", "map.yaml");
  return deck;
}

}  // namespace

Target target_nairn() {
  return {"nairn", "decks for NairnMPM with the body force of the plane vortex as functions", SeedPlace::two_by_two,
          [](const ExportedProblem& problem) { return fault_of_expressions(problem, "NairnMPM"); }, nairn_deck};
}

}  // namespace assay::drivers
