// SPDX-License-Identifier: BSD-3-Clause
// For FEniCSx 0.5: a driver that needs no assay, with the material's energy and the body force at the nodes.
#include "drivers/export/export.hpp"
#include "drivers/export/force_table.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/unseen.hpp"

namespace assay::drivers {

namespace {

std::string refusal_of_driver(const ExportedProblem& problem) {
  if (problem.quasi_static)
    return "the driver has inertia: leave force.quasi_static out, or use --to csv or nodal-loads";
  return refusal_of_loaded_surface(problem);
}

/// Strain energy per reference volume in UFL; empty where it is not known.
std::string energy_lines(const Scene& scene) {
  const std::string& name = scene.material.adapter;
  const auto number = [&](const char* parameter) { return number_text(scene.material.parameters.at(parameter)); };
  if (name == "neo_hookean" || name == "saint_venant_kirchhoff") {
    return filled_template("fenics", name + ".py", {{"E", number("E")}, {"NU", number("nu")}});
  }
  if (name == "mooney_rivlin") {
    return filled_template("fenics", name + ".py",
                           {{"C10", number("c10")}, {"C01", number("c01")}, {"KAPPA", number("bulk_modulus")}});
  }
  return {};
}

std::string grid_lines(const ExportedProblem& problem) {
  std::string lines;
  for (const ExportedGrid& grid : problem.grids) {
    const auto list = [&](const auto& numbers) {
      std::string text;
      for (std::size_t d = 0; d < static_cast<std::size_t>(problem.dimension); ++d)
        text += (d > 0 ? ", " : "[") + number_text(numbers[d]);
      return text + "]";
    };
    lines += "    \"" + grid.folder + "\": dict(h=" + number_text(grid.h) + ", lower=" + list(grid.lower) +
             ", upper=" + list(grid.upper) + ", cells=" + list(grid.cells) + "),\n";
  }
  return lines;
}

Deck fenics_deck(const ExportedProblem& problem) {
  Deck deck;
  std::string rows;
  for (const ExportedGrid& grid : problem.grids) {
    const ForceTable table = body_force_table(problem, grid);
    deck.files[grid.folder + "/force.bin"] = bytes_of_table(table);
    deck.runs.push_back(grid.folder + "/out.npz");
    rows += "- `" + grid.folder + "`: " + table_words(table, "m/s2") + "\n";
  }
  deck.files["force_table.py"] = filled_template("common", "force_table.py");
  const std::string energy = energy_lines(problem.scene);
  const std::string known = energy.empty() ? filled_template("fenics", "unknown.py") : energy;
  deck.files["run.py"] = filled_template("fenics", "run.py",
                                         {{"GRIDS", grid_lines(problem)},
                                          {"DENSITY", number_text(problem.density)},
                                          {"END", number_text(problem.end)},
                                          {"WAVE", number_text(problem.wave_speed)},
                                          {"ENERGY", known}});
  deck.readme = filled_template(
      "fenics", "README.md",
      {{"TABLES", rows},
       {"MATERIAL_WORDS",
        energy.empty() ? "The energy of `" + shown(problem.scene.material.adapter, 80) +
                             "` is not known: write it into the function `energy` of `run.py`, at the marked place."
                       : "The material is its strain energy, in the function `energy` of `run.py`."}});
  deck.map = filled_template("fenics", "map.yaml");
  return deck;
}

}  // namespace

Target target_fenics() {
  return {"fenics", "a driver for FEniCSx 0.5: total Lagrangian, explicit dynamics", SeedPlace::nodes,
          refusal_of_driver, fenics_deck};
}

}  // namespace assay::drivers
