// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/export/dynamic_deck.hpp"

#include <algorithm>

#include "drivers/export/force_table.hpp"
#include "drivers/export/mesh_text.hpp"

namespace assay::drivers {

namespace {

constexpr double no_load = 1e-13;        ///< of the largest force: rounding
constexpr double straight_error = 1e-3;  ///< of straight lines between times, of the largest force
constexpr std::size_t first_intervals = 64, most_straight_intervals = 1024;

std::vector<Vector3> vectors_of(const ForceTable& table, double t) {
  const std::vector<double> values = table.at(t);
  std::vector<Vector3> vectors(table.points, Vector3::Zero());
  for (std::size_t k = 0; k < table.points; ++k) {
    for (std::size_t d = 0; d < table.dimension; ++d) vectors[k][static_cast<int>(d)] = values[k * table.dimension + d];
  }
  return vectors;
}

double largest_difference(const std::vector<Vector3>& a, const std::vector<Vector3>& b) {
  double largest = 0;
  for (std::size_t k = 0; k < a.size(); ++k) largest = std::max(largest, (a[k] - b[k]).norm());
  return largest;
}

/// Forces at equal steps of time, so many that the straight lines between them are close.
std::vector<std::vector<Vector3>> straight_forces(const ForceTable& table, double end, double& error) {
  for (std::size_t intervals = first_intervals;; intervals *= 2) {
    std::vector<std::vector<Vector3>> forces;
    const double step = end / static_cast<double>(intervals);
    for (std::size_t k = 0; k <= intervals; ++k) forces.push_back(vectors_of(table, step * static_cast<double>(k)));
    error = 0;
    for (std::size_t k = 0; k < intervals; ++k) {
      std::vector<Vector3> middle = forces[k];
      for (std::size_t p = 0; p < middle.size(); ++p) middle[p] = 0.5 * (forces[k][p] + forces[k + 1][p]);
      error = std::max(error, largest_difference(middle, vectors_of(table, step * (static_cast<double>(k) + 0.5))));
    }
    if (table.largest > 0) error /= table.largest;
    if (error <= straight_error || intervals >= most_straight_intervals) return forces;
  }
}

std::string velocities_of(const ExportedGrid& grid, int dimension) {
  std::string text;
  for (std::size_t k = 0; k < grid.size(); ++k) {
    for (int d = 0; d < dimension; ++d) {
      if (grid.v0[k][d] != 0)
        text += std::to_string(grid.id[k]) + ", " + std::to_string(d + 1) + ", " + deck_number(grid.v0[k][d]) + "\n";
    }
  }
  return text.empty() ? text : "*INITIAL CONDITIONS, TYPE=VELOCITY\n" + text;
}

/// Each node twice, one metre apart.
ExportedGrid layer_of(const ExportedGrid& plane) {
  ExportedGrid solid = plane;
  solid.cells[2] = 1, solid.lower[2] = 0, solid.upper[2] = 1;
  for (std::size_t k = 0; k < plane.size(); ++k) {
    solid.id.push_back(plane.id[k] + static_cast<std::int64_t>(plane.size()));
    solid.X.emplace_back(plane.X[k].x(), plane.X[k].y(), 1);
    solid.v0.push_back(plane.v0[k]);
  }
  return solid;
}

}  // namespace

std::vector<char> loaded_nodes(const std::vector<std::vector<Vector3>>& forces, std::size_t nodes) {
  double largest = 0;
  for (const auto& level : forces) {
    for (const Vector3& force : level) largest = std::max(largest, force.cwiseAbs().maxCoeff());
  }
  std::vector<char> loaded(nodes, 0);
  for (const auto& level : forces) {
    for (std::size_t k = 0; k < nodes; ++k) loaded[k] |= level[k].cwiseAbs().maxCoeff() > no_load * largest;
  }
  return loaded;
}

DynamicLoads dynamic_loads(const ExportedProblem& problem, const ExportedGrid& grid) {
  const ForceTable table = nodal_load_table(problem, grid);
  const bool plane = problem.dimension == 2;
  DynamicLoads deck;
  deck.solid = plane ? layer_of(grid) : grid;
  const std::string share = plane ? ", 0.5\n" : ", 1.\n";
  const auto forces = straight_forces(table, problem.end, deck.error);
  deck.times = forces.size();
  const double step = problem.end / static_cast<double>(forces.size() - 1);
  const std::vector<char> loaded = loaded_nodes(forces, grid.size());
  constexpr std::size_t pairs_of_line = 4;
  for (std::size_t k = 0; k < grid.size(); ++k) {
    for (int d = 0; loaded[k] && d < problem.dimension; ++d) {
      const std::string node = std::to_string(grid.id[k]), direction = std::to_string(d + 1);
      std::string name = "F" + node;
      name += "_" + direction;
      deck.amplitudes += "*AMPLITUDE, NAME=" + name + "\n";
      for (std::size_t i = 0; i < forces.size(); ++i) {
        deck.amplitudes += deck_number(step * static_cast<double>(i)) + ", " + deck_number(forces[i][k][d]);
        deck.amplitudes += i % pairs_of_line == pairs_of_line - 1 || i + 1 == forces.size() ? "\n" : ", ";
      }
      deck.loads += "*CLOAD, AMPLITUDE=" + name + "\n";
      for (std::size_t n = k; n < deck.solid.size(); n += grid.size())
        deck.loads += std::to_string(deck.solid.id[n]) + ", " + direction + share;
    }
  }
  deck.amplitudes += velocities_of(deck.solid, problem.dimension);
  return deck;
}

}  // namespace assay::drivers
