// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/export/pages.hpp"

#include "drivers/command_line/project_templates.hpp"
#include "drivers/format/csv.hpp"
#include "drivers/result/result.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/wrapped_text.hpp"

namespace assay::drivers {

namespace {

std::string with_words(std::string text, const std::map<std::string, std::string>& words) {
  for (const auto& [word, by] : words) {
    const std::string mark = "@" + word + "@";
    for (std::size_t at = 0; (at = text.find(mark, at)) != text.npos; at += by.size())
      text.replace(at, mark.size(), by);
  }
  return text;
}

const char* seed_words(const ExportedProblem& problem, const Target& target) {
  if (target.seeds == SeedPlace::nodes) return "Nodes";
  if (target.seeds == SeedPlace::two_by_two) return "Particles, two along each edge of a cell";
  if (target.seeds == SeedPlace::cell_centres || problem.dimension == 2) return "Particles, in the middle of the cells";
  return "Particles, in the middle and at the corners of the cells";
}

std::string list_of_grids(const ExportedProblem& problem, const Target& target) {
  std::string rows;
  for (const ExportedGrid& grid : problem.grids) {
    std::string cells;
    for (int d = 0; d < problem.dimension; ++d)
      cells += (d > 0 ? " x " : "") + std::to_string(grid.cells[static_cast<std::size_t>(d)]);
    rows += "| `" + grid.folder + "` | " + rounded_text(grid.h, 6) + " m | " + cells + " | " +
            grouped_text(static_cast<std::int64_t>(grid.size())) + " |\n";
  }
  return std::string("| Folder | h | Cells | ") + seed_words(problem, target) + " |\n| --- | --- | --- | --- |\n" +
         rows;
}

std::string box_words(const ExportedProblem& problem) {
  const ExportedGrid& grid = problem.grids.front();
  if (grid.ring)
    return "ring between the radii " + rounded_text(grid.ring->inner, 6) + " and " + rounded_text(grid.ring->outer, 6) +
           " m";
  std::string box;
  for (std::size_t d = 0; d < static_cast<std::size_t>(problem.dimension); ++d)
    box += (d > 0 ? " x [" : "[") + rounded_text(grid.lower[d], 6) + ", " + rounded_text(grid.upper[d], 6) + "]";
  return box + " m";
}

std::string material_words(const Scene& scene) {
  std::string words = "`" + scene.material.adapter + "`";
  for (const auto& [name, value] : scene.material.parameters) words += ", " + name + " = " + number_text(value);
  return words;
}

std::string surface_words(const ExportedProblem& problem) {
  if (problem.rests_at_edge)
    return "The surface of the body stands still and bears no tractions: it may be held or free.";
  if (!problem.bears_tractions) return "The surface of the body bears no tractions: it is free.";
  return "The surface of the body moves and bears tractions.";
}

}  // namespace

std::string filled_template(const std::string& folder, const std::string& file,
                            const std::map<std::string, std::string>& words) {
  for (const ProjectTemplate& each : project_templates()) {
    if (each.flavour == "export/" + folder && each.file == file) return with_words(std::string(each.text), words);
  }
  throw std::logic_error("no template export/" + folder + "/" + file);
}

std::string seeds_csv(const ExportedGrid& grid, int dimension) {
  const bool space = dimension == 3;
  CsvText text(space ? std::vector<std::string>{"id", "X", "Y", "Z", "volume", "mass", "vx", "vy", "vz"}
                     : std::vector<std::string>{"id", "X", "Y", "volume", "mass", "vx", "vy"});
  for (std::size_t k = 0; k < grid.size(); ++k) {
    std::vector<double> row{static_cast<double>(grid.id[k])};
    for (int d = 0; d < dimension; ++d) row.push_back(grid.X[k][d]);
    row.push_back(grid.volume[k]), row.push_back(grid.mass[k]);
    for (int d = 0; d < dimension; ++d) row.push_back(grid.v0[k][d] + 0.0);  // 0 for -0
    text.row(row);
  }
  return text.text();
}

std::string map_of(const ExportedProblem& problem, const Deck& deck) {
  return "# How `assay judge` reads what this run leaves.\n" + deck.map + "scene_sha256: " + problem.scene_sha256 +
         "\n";
}

std::string readme_of(const ExportedProblem& problem, const Target& target, const Deck& deck) {
  std::string runs, spacings, remarks;
  for (const std::string& run : deck.runs) runs += " " + run;
  for (const ExportedGrid& grid : problem.grids) spacings += (spacings.empty() ? "" : ",") + rounded_text(grid.h, 6);
  for (const std::string& remark : problem.remarks) remarks += wrapped(remark + ".", "- ", "  ", page_width);
  if (!remarks.empty()) remarks = "\n" + remarks;
  const bool space = problem.dimension == 3;
  return filled_template(
      "common", "README.md",
      {{"TITLE", problem.scene.title.empty() ? "A problem with an exact solution" : problem.scene.title},
       {"TARGET", target.name},
       {"VERSION", build_information().version},
       {"OWN", deck.readme},
       {"GRIDS", list_of_grids(problem, target)},
       {"BOX", box_words(problem)},
       {"MATERIAL", material_words(problem.scene)},
       {"DENSITY", number_text(problem.density)},
       {"END", number_text(problem.end)},
       {"PERIOD", number_text(problem.period)},
       {"WAVE", rounded_text(problem.wave_speed, 4)},
       {"INERTIA", problem.quasi_static ? "The problem is quasi-static: there is no inertia and no initial velocity. "
                                          "Time is a parameter of the load.\n"
                                        : ""},
       {"PLANE", space ? "" : "The problem is plane strain. Volumes, masses and forces are per metre of thickness.\n"},
       {"SURFACE", surface_words(problem)},
       {"REMARKS", remarks},
       {"RUNS", runs},
       {"SPACINGS", spacings}});
}

std::map<std::string, std::string> folder_of(const ExportedProblem& problem, const Target& target) {
  Deck deck = target.write(problem);
  deck.files["scene.yaml"] = problem.scene_yaml;
  deck.files["judge.map.yaml"] = map_of(problem, deck);
  deck.files["README.md"] = readme_of(problem, target, deck);
  for (const ExportedGrid& grid : problem.grids)
    deck.files[grid.folder + "/seeds.csv"] = seeds_csv(grid, problem.dimension);
  return std::move(deck.files);
}

}  // namespace assay::drivers
