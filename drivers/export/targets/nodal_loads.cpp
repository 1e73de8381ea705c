// SPDX-License-Identifier: BSD-3-Clause
// For any finite element code: a mesh, and consistent forces on its nodes as a table over time.
#include "drivers/export/export.hpp"
#include "drivers/export/force_table.hpp"
#include "drivers/export/mesh_text.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

std::string support_words(const ExportedProblem& problem) {
  if (problem.rests_at_edge)
    return problem.quasi_static ? "Hold the nodes of `surface.csv`: nothing else supports the body."
                                : "Hold the nodes of `surface.csv`, or leave them free: they stand still.";
  if (problem.quasi_static)
    return "Without inertia something must support the body: prescribe the exact displacement at as many nodes as "
           "rigid "
           "motions ask for. `assay eval scene.yaml --points FILE` writes it.";
  return "All nodes are free: the forces contain the tractions on the surface.";
}

Deck nodal_loads_deck(const ExportedProblem& problem) {
  Deck deck;
  deck.files = table_routines();
  std::string rows;
  for (const ExportedGrid& grid : problem.grids) {
    const ForceTable table = nodal_load_table(problem, grid);
    deck.files[grid.folder + "/loads.bin"] = bytes_of_table(table);
    deck.files[grid.folder + "/elements.csv"] = elements_csv(grid, problem.dimension);
    deck.files[grid.folder + "/surface.csv"] = surface_csv(grid, problem.dimension);
    deck.runs.push_back(grid.folder + "/out.csv");
    rows += "- `" + grid.folder + "`: " + table_words(table, problem.dimension == 3 ? "N" : "N/m") + "\n";
  }
  const bool space = problem.dimension == 3;
  deck.readme = filled_template("nodal_loads", "README.md",
                                {{"TABLES", rows},
                                 {"FOLDER", problem.grids.front().folder},
                                 {"ELEMENT", space ? "hexahedron with eight nodes" : "quadrilateral with four nodes"},
                                 {"SUPPORT", support_words(problem)},
                                 {"HEADER", space ? "t,id,X,Y,Z,ux,uy,uz" : "t,id,X,Y,ux,uy"}});
  deck.map = filled_template("nodal_loads", space ? "map3.yaml" : "map2.yaml");
  return deck;
}

}  // namespace

Target target_nodal_loads() {
  return {"nodal-loads", "a mesh and consistent nodal forces, for any finite element code", SeedPlace::nodes, nullptr,
          nodal_loads_deck};
}

}  // namespace assay::drivers
