// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/export/mesh_text.hpp"

#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

/// Rows "1<between>12<between>13": an element and its nodes, all from 1.
std::string element_rows(const ElementMesh& mesh, const std::string& between) {
  std::string text;
  const std::size_t nodes = mesh.nodes_of_element();
  for (std::size_t e = 0; e < mesh.elements(); ++e) {
    text += std::to_string(e + 1);
    for (std::size_t k = 0; k < nodes; ++k)
      text.append(between).append(std::to_string(mesh.connectivity[e * nodes + k] + 1));
    text += '\n';
  }
  return text;
}

}  // namespace

std::string elements_csv(const ExportedGrid& grid, int dimension) {
  const ElementMesh mesh = mesh_of(grid, dimension);
  std::string text = "id";
  for (std::size_t k = 1; k <= mesh.nodes_of_element(); ++k) text += ",n" + std::to_string(k);
  return text + "\n" + element_rows(mesh, ",");
}

std::string surface_csv(const ExportedGrid& grid, int dimension) {
  std::string text = "id\n";
  for (std::size_t k = 0; k < grid.size(); ++k) {
    if (is_on_surface(grid, dimension, grid.X[k])) text += std::to_string(grid.id[k]) + "\n";
  }
  return text;
}

std::string deck_number(double value) {
  constexpr int digits = 12;  // with sign, point and exponent 19 characters
  std::string text = rounded_text(value, digits);
  return text.find_first_of(".e") == text.npos ? text + "." : text;
}

std::string mesh_of_deck(const ExportedGrid& grid, int dimension, const std::string& element, int across) {
  std::string text = "*NODE, NSET=ALL\n";
  for (std::size_t k = 0; k < grid.size(); ++k) {
    text += std::to_string(grid.id[k]);
    for (int d = 0; d < dimension; ++d) text += ", " + deck_number(grid.X[k][d]);
    text += '\n';
  }
  text += "*ELEMENT, TYPE=" + element + ", ELSET=BODY\n" + element_rows(mesh_of(grid, dimension), ", ");
  text += "*NSET, NSET=EDGE\n";
  for (std::size_t k = 0; k < grid.size(); ++k) {
    if (is_on_surface(grid, across, grid.X[k])) text += std::to_string(grid.id[k]) + ",\n";
  }
  return text;
}

}  // namespace assay::drivers
