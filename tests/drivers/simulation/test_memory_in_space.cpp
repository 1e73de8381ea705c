// SPDX-License-Identifier: BSD-3-Clause
// What is estimated of the mass matrix before it is made: rows of the nodes near the surface alone.
#include <gtest/gtest.h>

#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/problem.hpp"
#include "mpm/compose.hpp"
#include "mpm/mass/surface_rows.hpp"

namespace assay::drivers::test_memory_in_space {
namespace {

template <int Dim>
ProblemIn<Dim> box(const std::string& method, const std::string& upper) {
  const std::string size = Dim == 3 ? "lower: [0, 0, 0], upper: [" + upper + "]" : "lower: [0, 0], upper: [1, 1]";
  return assemble<Dim>(scene_from_text("dimension: " + std::to_string(Dim) +
                                           "\nmotion: {type: rigid}\ngrid: {spacing: 0.125}\n"
                                           "material: {adapter: neo_hookean, parameters: {E: 1000, nu: 0.3}, density: "
                                           "1000}\nbody: {domain: box, " +
                                           size + "}\nmethod: {transfer: aflip, " + method + "}\n",
                                       "box.yaml", {}),
                       1);
}

const char* const series = "basis: bspline2, formulation: total, mass: series, terms: 4";

/// A node of quadratic B-splines reaches two cells to each side. Of n cells the nodes -1 to n + 1 reach the body, and 2
/// to n - 2 lie among full cells.
std::size_t rows_of_box(std::size_t a, std::size_t b, std::size_t c) {
  return (a + 3) * (b + 3) * (c + 3) - (a - 3) * (b - 3) * (c - 3);
}

TEST(MemoryInSpace, CountsTheNodesNearTheSurface) {
  EXPECT_EQ(mpm::nodes_with_mass_rows(box<3>(series, "1, 1, 1").setup), rows_of_box(8, 8, 8));
  EXPECT_EQ(mpm::nodes_with_mass_rows(box<3>(series, "1, 0.75, 0.5").setup), rows_of_box(8, 6, 4));
}

TEST(MemoryInSpace, HasNoRowsWithoutAMatrixThatIsMadeOnce) {
  EXPECT_EQ(mpm::nodes_with_mass_rows(box<3>("basis: bspline2, formulation: total", "1, 1, 1").setup), 0u);
  EXPECT_EQ(mpm::mass_row_bytes(box<3>("basis: bspline2, mass: series, terms: 2", "1, 1, 1").setup), 0u);
}

TEST(MemoryInSpace, CountsAllNodesOfThePlane) {
  const ProblemIn<2> plane = box<2>(series, "");
  EXPECT_EQ(mpm::nodes_with_mass_rows(plane.setup), plane.setup.grid.nodes());
}

/// The estimate has the rows of these nodes, and no others.
TEST(MemoryInSpace, EstimatesTheRowsOfTheseNodes) {
  const ProblemIn<3> with = box<3>(series, "2, 2, 2");
  const auto rows = static_cast<double>(mpm::nodes_with_mass_rows(with.setup));
  const auto row = static_cast<double>(mpm::mass_row_bytes(with.setup));
  EXPECT_EQ(row, 125 * sizeof(double));
  // Cubic B-splines take the same columns and fields, and rows of 343 numbers at more nodes.
  const ProblemIn<3> wider = box<3>("basis: bspline3, formulation: total, mass: series, terms: 4", "2, 2, 2");
  const auto wide_rows = static_cast<double>(mpm::nodes_with_mass_rows(wider.setup));
  const double fields = static_cast<double>(mpm::grid_bytes_per_node(with.setup) - mpm::mass_row_bytes(with.setup));
  const double more_nodes =
      static_cast<double>(wider.setup.grid.nodes()) - static_cast<double>(with.setup.grid.nodes());
  EXPECT_NEAR(wider.estimated_bytes() - with.estimated_bytes(),
              wide_rows * static_cast<double>(mpm::mass_row_bytes(wider.setup)) - rows * row + more_nodes * fields, 1);
}

}  // namespace
}  // namespace assay::drivers::test_memory_in_space
