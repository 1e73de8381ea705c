// SPDX-License-Identifier: BSD-3-Clause
// For LAMMPS: in space peridynamics with a table of the body force, in the plane expressions for a pair style of the
// user's own.
#include "drivers/export/export.hpp"
#include "drivers/export/exported_force.hpp"
#include "drivers/export/force_expressions.hpp"
#include "drivers/export/force_table.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

constexpr double lammps_courant = 0.4;
/// Of the lattice constant: a body-centred lattice is isotropic with it, and has the shear modulus that is asked for.
constexpr double peri_horizon = 2.28277;
constexpr double peri_skin = 0.2;  ///< of the lattice constant

std::string refusal_of_lammps(const ExportedProblem& problem) {
  if (problem.dimension == 2 || problem.quasi_static) return fault_of_expressions(problem, "LAMMPS");
  if (std::string why = refusal_of_loaded_surface(problem); !why.empty()) return why;
  if (rest_moduli(*problem.material)) return {};
  return "peri/lps is an isotropic elastic solid, and the material is none: use --to csv";
}

using LammpsWords = std::map<std::string, std::string>;

LammpsWords run_words(const ExportedSteps& steps) {
  return {{"EVERY", std::to_string(steps.every)},
          {"STEPS", std::to_string(steps.count)},
          {"STEP", number_text(steps.step)}};
}

/// Atoms of the style peri: id, type, volume, density, position; and their velocities.
std::string atoms_data(const ExportedGrid& grid, double density) {
  std::string text = "The seeds of " + grid.folder + "\n\n" + std::to_string(grid.size()) + " atoms\n1 atom types\n\n",
              velocities = "\nVelocities\n\n";
  constexpr const char* axes[] = {"x", "y", "z"};
  for (std::size_t d = 0; d < 3; ++d)
    text += number_text(grid.lower[d] - grid.h) + " " + number_text(grid.upper[d] + grid.h) + " " + axes[d] + "lo " +
            axes[d] + "hi\n";
  text += "\nAtoms\n\n";
  for (std::size_t k = 0; k < grid.size(); ++k) {
    const std::string id = std::to_string(grid.id[k]);
    text += id + " 1 " + number_text(grid.volume[k]) + " " + number_text(density);
    velocities += id;
    for (int d = 0; d < 3; ++d) {
      text += " " + number_text(grid.X[k][d]);
      velocities += " " + number_text(grid.v0[k][d]);
    }
    text += "\n", velocities += "\n";
  }
  return text + velocities;
}

Deck peri_deck(const ExportedProblem& problem) {
  Deck deck;
  const RestModuli moduli = *rest_moduli(*problem.material);
  LammpsWords all{{"BULK", rounded_text(moduli.bulk, 9)},
                  {"SHEAR", rounded_text(moduli.shear, 9)},
                  {"RATIO", number_text(peri_horizon)},
                  {"DENSITY", number_text(problem.density)},
                  {"FOLDER", problem.grids.front().folder}};
  std::string steps_of_grids;
  for (const ExportedGrid& grid : problem.grids) {
    const ExportedSteps steps = exported_steps(problem, grid.h, lammps_courant);
    LammpsWords words = run_words(steps);
    words.insert(all.begin(), all.end());
    words["SKIN"] = number_text(peri_skin * grid.h);
    words["HORIZON"] = number_text(peri_horizon * grid.h);
    const ForceTable table = body_force_table(problem, grid);
    deck.files[grid.folder + "/in.lammps"] = filled_template("lammps", "in_space.lammps", words);
    deck.files[grid.folder + "/atoms.data"] = atoms_data(grid, problem.density);
    deck.files[grid.folder + "/force.bin"] = bytes_of_table(table);
    deck.runs.push_back(grid.folder + "/out.dump");
    all["TABLES"] += "- `" + grid.folder + "`: " + table_words(table, "m/s2") + "\n";
    steps_of_grids += (steps_of_grids.empty() ? "{\"" : ", \"") + grid.folder + "\": " + std::to_string(steps.count);
  }
  all["STEPS"] = steps_of_grids + "}";
  deck.files["run.py"] = filled_template("lammps", "run.py", all);
  deck.files["force_table.py"] = filled_template("common", "force_table.py");
  deck.readme = filled_template("lammps", "README_space.md", all);
  deck.map = filled_template("lammps", "map_space.yaml");
  return deck;
}

/// Where the first site of a lattice of constant h lies, so that sites are centres of cells [h].
std::string lattice_origin(double lower, double h) {
  const double place = lower / h + 0.5, origin = place - std::floor(place);
  constexpr double rounding = 1e-9;
  return rounded_text(origin > 1 - rounding ? 0 : origin, 9);
}

Deck plane_deck(const ExportedProblem& problem) {
  Deck deck;
  const ForcePieces pieces = exported_pieces(problem, "lammps");
  for (const ExportedGrid& grid : problem.grids) {
    LammpsWords words = run_words(exported_steps(problem, grid.h, lammps_courant));
    words["SPACING"] = number_text(grid.h);
    words["VOLUME"] = number_text(grid.volume.front());
    words["DENSITY"] = number_text(problem.density);
    words["ORIGIN_X"] = lattice_origin(grid.lower[0], grid.h),
    words["ORIGIN_Y"] = lattice_origin(grid.lower[1], grid.h);
    words["LOWER_X"] = number_text(grid.lower[0]), words["UPPER_X"] = number_text(grid.upper[0]);
    words["LOWER_Y"] = number_text(grid.lower[1]), words["UPPER_Y"] = number_text(grid.upper[1]);
    words["LOWER_Z"] = number_text(-0.5 * grid.h), words["UPPER_Z"] = number_text(0.5 * grid.h);
    deck.files[grid.folder + "/in.lammps"] = filled_template("lammps", "in_plane.lammps", words);
    deck.runs.push_back(grid.folder + "/out.dump");
  }
  deck.files["style.in"] = filled_template("lammps", "style.in");
  deck.files["material.in"] = filled_template("lammps", "material.in");
  deck.files["force.in"] = "# b_x, b_y [m/s^2] and v_x, v_y [m/s]. Written by assay export.\n" +
                           lammps_force(pieces, ForceCoordinates::reference);
  deck.readme = filled_template("lammps", "README_plane.md", {{"PIECES", pieces_words(pieces)}});
  deck.map = filled_template("lammps", "map_plane.yaml");
  return deck;
}

Deck lammps_deck(const ExportedProblem& problem) {
  return problem.dimension == 3 ? peri_deck(problem) : plane_deck(problem);
}

}  // namespace

Target target_lammps() {
  return {"lammps", "peridynamics in space; in the plane the body force for your pair style", SeedPlace::body_centred,
          refusal_of_lammps, lammps_deck};
}

}  // namespace assay::drivers
