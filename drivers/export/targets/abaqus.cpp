// SPDX-License-Identifier: BSD-3-Clause
// For Abaqus and CalculiX: complete decks for each grid, loaded by nodal forces.
//
// Quasi-static: load levels are steps. Within one the loads go straight from the level before to the next, in both
// codes. What is judged is the end of each step, where the nodal forces are those of the exact solution. With inertia:
// one step, in which each load has its history as an amplitude.
#include <algorithm>
#include <cmath>

#include "drivers/export/deck_law.hpp"
#include "drivers/export/dynamic_deck.hpp"
#include "drivers/export/export.hpp"
#include "drivers/export/exported_force.hpp"
#include "drivers/export/mesh_text.hpp"
#include "drivers/export/pages.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/wrapped_text.hpp"

namespace assay::drivers {

namespace {

constexpr int levels_of_period = 16;
constexpr double courant = 0.5;  ///< of the increments of CalculiX
constexpr int frames = 20;       ///< that a dynamic analysis writes

std::string refusal_of_deck(const ExportedProblem& problem) {
  if (problem.rests_at_edge) return {};
  return "the deck holds the surface of the body, and this motion moves it: use --to nodal-loads";
}

std::vector<double> load_levels(const ExportedProblem& problem) {
  const auto count = static_cast<int>(std::ceil(problem.end / problem.period * levels_of_period - 1e-9));
  std::vector<double> times;
  for (int k = 1; k <= count; ++k) times.push_back(problem.end * k / count);
  return times;
}

/// Nodal forces without inertia at the levels [N], in the plane per metre [N/m].
std::vector<std::vector<Vector3>> forces_at(const ExportedProblem& problem, const ExportedGrid& grid,
                                            const std::vector<double>& times) {
  const NodalLoads loads(mesh_of(grid, problem.dimension), *problem.exact, problem.density, {.quasi_static = true});
  std::vector<std::vector<Vector3>> forces;
  for (const double t : times) forces.push_back(loads.at(*problem.exact->slice(t)));
  return forces;
}

/// A load stays until it is replaced, so each level names all nodes that are ever loaded.
std::string loads_text(const ExportedGrid& grid, int dimension, const std::vector<Vector3>& forces,
                       const std::vector<char>& loaded) {
  std::string text = "*CLOAD\n";
  for (std::size_t k = 0; k < grid.size(); ++k) {
    for (int d = 0; loaded[k] && d < dimension; ++d)
      text += std::to_string(grid.id[k]) + ", " + std::to_string(d + 1) + ", " + deck_number(forces[k][d]) + "\n";
  }
  return text;
}

std::string steps_text(const ExportedProblem& problem, const ExportedGrid& grid) {
  const std::vector<double> times = load_levels(problem);
  const auto forces = forces_at(problem, grid, times);
  const std::vector<char> loaded = loaded_nodes(forces, grid.size());
  std::string text;
  double before = 0;
  for (std::size_t k = 0; k < times.size(); ++k) {
    const double step = times[k] - before;
    text += "** to t = " + rounded_text(times[k], 6) + " s\n*STEP, NLGEOM=YES, INC=1000\n*STATIC\n" +
            deck_number(step) + ", " + deck_number(step) + ", " + deck_number(1e-4 * step) + ", " + deck_number(step) +
            "\n" + loads_text(grid, problem.dimension, forces[k], loaded) +
            "*NODE PRINT, NSET=ALL, FREQUENCY=1000\nU\n*NODE FILE, FREQUENCY=1000\nU\n*END STEP\n";
    before = times[k];
  }
  return text;
}

std::string material_text(const ExportedProblem& problem, const DeckLaw& material, int dimension) {
  return "*MATERIAL, NAME=" + material.name + "\n" + material.lines + "*DENSITY\n" + deck_number(problem.density) +
         "\n*SOLID SECTION, ELSET=BODY, MATERIAL=" + material.name + "\n" + (dimension == 3 ? "" : "1.\n");
}

std::string deck_text(const ExportedProblem& problem, const ExportedGrid& grid, const std::string& material,
                      const std::string& mesh, const std::string& steps) {
  const std::string title = problem.scene.title.empty() ? "a problem with an exact solution" : problem.scene.title;
  return "*HEADING\n" + title + ", h = " + rounded_text(grid.h, 6) + " m; SI units\n*INCLUDE, INPUT=" + mesh + "\n" +
         material + "*BOUNDARY\nEDGE, 1, " + std::to_string(problem.dimension) + "\n" + steps;
}

/// Increments that a whole number of times make the time between two frames.
std::size_t increments_of_frame(const ExportedProblem& problem, const ExportedGrid& grid) {
  const double increments = problem.end * problem.wave_speed / (courant * grid.h);
  return static_cast<std::size_t>(std::max(1.0, std::ceil(increments / frames)));
}

/// Abaqus/Explicit and CalculiX's implicit dynamics, which have inertia. Plane strain is a layer of hexahedra: plane
/// linear elements of CalculiX 2.20 have half of their mass, and those of Abaqus/Explicit have one integration point.
void add_dynamic_decks(const ExportedProblem& problem, const ExportedGrid& grid, const DeckLaws& laws, Deck& deck,
                       std::string& words) {
  const std::string folder = grid.folder + "/", end = deck_number(problem.end);
  const DynamicLoads loads = dynamic_loads(problem, grid);
  deck.files[folder + "amplitudes.inp"] = loads.amplitudes;
  deck.files[folder + "loads.inp"] = loads.loads;
  deck.files[folder + "mesh_dynamic.inp"] = mesh_of_deck(loads.solid, 3, "C3D8", problem.dimension);
  const auto deck_of = [&](const DeckLaw& law, const std::string& procedure, const std::string& output) {
    const std::string plane = problem.dimension == 2 ? "ALL, 3, 3\n" : "";
    return deck_text(problem, grid, material_text(problem, law, 3), "mesh_dynamic.inp",
                     plane + "*INCLUDE, INPUT=amplitudes.inp\n" + procedure + "*INCLUDE, INPUT=loads.inp\n" + output +
                         "U\n*END STEP\n");
  };
  const std::string count = std::to_string(frames);
  deck.files[folder + "abaqus_explicit.inp"] =
      deck_of(laws.abaqus, "*STEP, NLGEOM=YES\n*DYNAMIC, EXPLICIT\n, " + end + "\n",
              "*OUTPUT, FIELD, NUMBER INTERVAL=" + count + ", TIME MARKS=YES\n*NODE OUTPUT, NSET=ALL\n");
  const std::size_t increments = increments_of_frame(problem, grid);
  const double step = problem.end / static_cast<double>(increments * frames);
  deck.files[folder + "calculix_dynamic.inp"] = deck_of(
      laws.calculix, "*STEP, NLGEOM, INC=1000000\n*DYNAMIC, DIRECT, ALPHA=0.\n" + deck_number(step) + ", " + end + "\n",
      "*NODE PRINT, NSET=ALL, FREQUENCY=" + std::to_string(increments) + "\n");
  words += "- `" + grid.folder + "`: amplitudes of " + std::to_string(loads.times) +
           " times. Straight lines between them are off by at most " + rounded_text(loads.error, 2) +
           " of the largest force.\n";
}

Deck abaqus_deck_of(const ExportedProblem& problem) {
  Deck deck;
  const DeckLaws materials = deck_laws(problem);
  const std::string element = problem.dimension == 3 ? "C3D8" : "CPE4";
  const std::string steps = "*INCLUDE, INPUT=steps.inp\n";
  std::string commands, dynamic_words;
  for (const ExportedGrid& grid : problem.grids) {
    const std::string folder = grid.folder + "/";
    deck.files[folder + "mesh.inp"] = mesh_of_deck(grid, problem.dimension, element, problem.dimension);
    deck.files[folder + "steps.inp"] = steps_text(problem, grid);
    deck.files[folder + "calculix.inp"] =
        deck_text(problem, grid, material_text(problem, materials.calculix, problem.dimension), "mesh.inp", steps);
    deck.files[folder + "abaqus.inp"] =
        deck_text(problem, grid, material_text(problem, materials.abaqus, problem.dimension), "mesh.inp", steps);
    if (!problem.quasi_static) add_dynamic_decks(problem, grid, materials, deck, dynamic_words);
    deck.runs.push_back(folder + "out.csv");
    commands += "(cd " + grid.folder + " && ccx calculix && python3 ../dat_to_csv.py)\n";
  }
  deck.files["dat_to_csv.py"] = filled_template("abaqus", "dat_to_csv.py");
  deck.files["odb_to_csv.py"] = filled_template("abaqus", "odb_to_csv.py");
  deck.readme = filled_template(
      "abaqus", "README.md",
      {{"MATERIAL_WORDS", wrapped(materials.words, "", "", page_width)},
       {"ELEMENT", element},
       {"COMMANDS", commands},
       {"DYNAMIC", problem.quasi_static ? "" : filled_template("abaqus", "dynamic.md", {{"TIMES", dynamic_words}})},
       {"LEVELS", std::to_string(load_levels(problem).size())}});
  deck.readme += add_abaqus_routines(problem, deck);
  deck.map = filled_template("nodal_loads", problem.dimension == 3 ? "map3.yaml" : "map2.yaml");
  return deck;
}

}  // namespace

Target target_abaqus() {
  return {"abaqus", "decks for Abaqus and CalculiX, loaded by nodal forces", SeedPlace::nodes, refusal_of_deck,
          abaqus_deck_of};
}

}  // namespace assay::drivers
