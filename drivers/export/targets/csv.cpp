// SPDX-License-Identifier: BSD-3-Clause
// For any code: particles as CSV, and the body force as a table over time with routines that read it.
#include "drivers/format/csv.hpp"
#include "drivers/export/export.hpp"
#include "drivers/export/exported_force.hpp"
#include "drivers/export/force_table.hpp"
#include "drivers/format/npz.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

std::string npz_of_table(const ForceTable& table) {
  std::vector<double> t(table.times);
  for (std::size_t k = 0; k < t.size(); ++k) t[k] = table.step * static_cast<double>(k);
  return npz_bytes({{"t", {table.times}, t}, {"b", {table.times, table.points, table.dimension}, table.values}});
}

/// id, X, Y, NX, NY, area: of each face the particle in its cell, its middle, its normal.
std::string faces_csv(const ExportedGrid& grid, const std::vector<SurfaceFace>& faces, int dimension) {
  const bool space = dimension == 3;
  CsvText text(space ? std::vector<std::string>{"id", "X", "Y", "Z", "NX", "NY", "NZ", "area"}
                     : std::vector<std::string>{"id", "X", "Y", "NX", "NY", "area"});
  for (const SurfaceFace& face : faces) {
    std::vector<double> row{static_cast<double>(grid.id[face.seed])};
    for (int d = 0; d < dimension; ++d) row.push_back(face.X[d]);
    for (int d = 0; d < dimension; ++d) row.push_back(face.normal[d] + 0.0);  // 0 for -0
    row.push_back(face.area);
    text.row(row);
  }
  return text.text();
}

Deck csv_deck(const ExportedProblem& problem) {
  Deck deck;
  deck.files = table_routines();
  std::string rows;
  for (const ExportedGrid& grid : problem.grids) {
    const ForceTable table = body_force_table(problem, grid);
    deck.files[grid.folder + "/force.bin"] = bytes_of_table(table);
    deck.files[grid.folder + "/force.npz"] = npz_of_table(table);
    deck.runs.push_back(grid.folder + "/out.csv");
    rows += "- `" + grid.folder + "`: " + table_words(table, "m/s2") + "\n";
    if (!problem.bears_tractions) continue;
    const std::vector<SurfaceFace> faces = surface_faces(grid, problem.dimension);
    const ForceTable tractions = traction_table(problem, faces);
    deck.files[grid.folder + "/faces.csv"] = faces_csv(grid, faces, problem.dimension);
    deck.files[grid.folder + "/tractions.bin"] = bytes_of_table(tractions);
    rows += "- `" + grid.folder + "`, tractions: " + table_words(tractions, "Pa") + "\n";
  }
  const bool space = problem.dimension == 3, moves = !problem.quasi_static;
  const std::string velocity = space ? "vx,vy,vz" : "vx,vy";
  deck.readme =
      filled_template("csv", "README.md",
                      {{"TABLES", rows},
                       {"FOLDER", problem.grids.front().folder},
                       {"TRACTIONS", problem.bears_tractions ? filled_template("csv", "tractions.md") : ""},
                       {"HEADER", (space ? "t,id,X,Y,Z,x,y,z" : "t,id,X,Y,x,y") + (moves ? "," + velocity : "")}});
  deck.readme += add_force_sources(problem, deck);
  deck.map =
      filled_template("csv", space ? "map3.yaml" : "map2.yaml", {{"VELOCITY", moves ? "v: [" + velocity + "]\n" : ""}});
  return deck;
}

}  // namespace

Target target_csv() {
  return {"csv", "particles and a table of the body force, for any code", SeedPlace::cell_centres, nullptr, csv_deck};
}

}  // namespace assay::drivers
