// SPDX-License-Identifier: BSD-3-Clause
// For Karamelo: total Lagrangian material points in the plane vortex, with the body force as an expression.
#include "drivers/export/exported_force.hpp"
#include "drivers/export/expression_text.hpp"
#include "drivers/export/force_expressions.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/unseen.hpp"

namespace assay::drivers {

namespace {

constexpr double karamelo_courant = 0.2;  ///< of a grid of linear functions with FLIP

/// As Karamelo reads it, with its sign.
std::string karamelo_number(double value) { return (value < 0 ? "-" : "") + SingleNumbers().text(std::abs(value)); }

std::string karamelo_material(const Scene& scene, double density) {
  const std::string& name = scene.material.adapter;
  if (name != "neo_hookean")
    return "# YOURS: material(solid1, ...) with the stress of " + shown(name, 60) + ", density " +
           karamelo_number(density);
  return "material(solid1, neo-hookean, " + karamelo_number(density) + ", " +
         karamelo_number(scene.material.parameters.at("E")) + ", " +
         karamelo_number(scene.material.parameters.at("nu")) + ")";
}

Deck karamelo_deck(const ExportedProblem& problem) {
  Deck deck;
  const Vortex& vortex = *problem.scene.motion.as<Vortex>();
  const ForcePieces pieces = exported_pieces(problem, "karamelo");
  std::string commands;
  for (const ExportedGrid& grid : problem.grids) {
    const ExportedSteps steps = steps_of_outputs(problem, grid.h, karamelo_courant);
    deck.files[grid.folder + "/input.mpm"] =
        filled_template("karamelo", "input.mpm",
                        {{"LOWER_X", karamelo_number(grid.lower[0])},
                         {"UPPER_X", karamelo_number(grid.upper[0])},
                         {"LOWER_Y", karamelo_number(grid.lower[1])},
                         {"UPPER_Y", karamelo_number(grid.upper[1])},
                         {"SPACING", karamelo_number(grid.h)},
                         {"INNER", karamelo_number(vortex.inner)},
                         {"OUTER", karamelo_number(vortex.outer)},
                         {"MATERIAL", karamelo_material(problem.scene, problem.density)},
                         {"FORCE", karamelo_force(pieces, ForceCoordinates::reference)},
                         {"EVERY", std::to_string(steps.every)},
                         {"STEPS", std::to_string(steps.count)},
                         {"END", karamelo_number(problem.end)}});
    deck.runs.push_back(grid.folder + "/out");
    commands += "(cd " + grid.folder + " && mkdir -p out && karamelo -i input.mpm)\n";
  }
  const bool own = problem.scene.material.adapter == "neo_hookean";
  deck.readme = filled_template(
      "karamelo", "README.md",
      {{"COMMANDS", commands},
       {"OUTPUTS", std::to_string(exported_outputs)},
       {"PIECES", pieces_words(pieces)},
       {"MATERIAL_WORDS", own ? "The material `neo-hookean` of Karamelo is that of the scene."
                              : "Karamelo has no material `" + shown(problem.scene.material.adapter, 60) +
                                    "` of its own: write yours at the marked line."}});
  std::string times;
  for (int k = 1; k <= exported_outputs; ++k)  // it writes nothing at the beginning
    times += (k > 1 ? ", " : "") + number_text(problem.end * k / exported_outputs);
  deck.map = filled_template("karamelo", "map.yaml", {{"TIMES", times}});
  return deck;
}

}  // namespace

Target target_karamelo() {
  return {"karamelo", "decks for Karamelo with the body force of the plane vortex as expressions",
          SeedPlace::two_by_two,
          [](const ExportedProblem& problem) { return fault_of_expressions(problem, "Karamelo"); }, karamelo_deck};
}

}  // namespace assay::drivers
