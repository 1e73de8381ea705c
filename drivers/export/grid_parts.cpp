// SPDX-License-Identifier: BSD-3-Clause
// Elements and surface of an exported grid, and grids that fill a ring.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "drivers/export/grids.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

constexpr double near_surface = 1e-6;  ///< of a cell

std::size_t of_axis(int d) { return static_cast<std::size_t>(d); }

Vector3 at_polar(double R, double angle) { return {R * std::cos(angle), R * std::sin(angle), 0}; }

/// A quarter of each element goes to each of its nodes.
std::vector<double> nodal_areas(const ElementMesh& mesh) {
  std::vector<double> area(mesh.X.size(), 0.0);
  for (std::size_t e = 0; e < mesh.elements(); ++e) {
    const auto node = [&](std::size_t k) { return static_cast<std::size_t>(mesh.connectivity[4 * e + k]); };
    const Vector3 a = mesh.X[node(2)] - mesh.X[node(0)], b = mesh.X[node(3)] - mesh.X[node(1)];
    for (std::size_t k = 0; k < 4; ++k) area[node(k)] += 0.125 * (a.x() * b.y() - a.y() * b.x());
  }
  return area;
}

}  // namespace

ElementMesh mesh_of(const ExportedGrid& grid, int dimension) {
  const bool plane = dimension == 2;
  ElementMesh mesh;
  mesh.shape = plane ? ElementMesh::Shape::quadrilateral : ElementMesh::Shape::hexahedron;
  mesh.X = grid.X;
  const std::int64_t row = grid.cells[0] + 1, layer = row * (grid.cells[1] + 1);
  for (int k = 0; k < grid.cells[2]; ++k) {
    for (int j = 0; j < grid.cells[1]; ++j) {
      const bool closes = grid.ring && j + 1 == grid.cells[1];
      for (int i = 0; i < grid.cells[0]; ++i) {
        const std::int64_t first = i + j * row + (plane ? 0 : k * layer), next = closes ? i : first + row;
        const std::array<std::int64_t, 4> face{first, first + 1, next + 1, next};
        mesh.connectivity.insert(mesh.connectivity.end(), face.begin(), face.end());
        if (plane) continue;
        for (const std::int64_t node : face) mesh.connectivity.push_back(node + layer);
      }
    }
  }
  return mesh;
}

bool is_on_surface(const ExportedGrid& grid, int dimension, const Vector3& X) {
  const double near = near_surface * grid.h;
  if (grid.ring) {
    const double R = X.norm();
    return std::min(std::abs(R - grid.ring->inner), std::abs(R - grid.ring->outer)) < near;
  }
  for (int d = 0; d < dimension; ++d) {
    if (std::min(X[d] - grid.lower[of_axis(d)], grid.upper[of_axis(d)] - X[d]) < near) return true;
  }
  return false;
}

std::vector<SurfaceFace> surface_faces(const ExportedGrid& grid, int dimension) {
  std::vector<SurfaceFace> faces;
  const auto add_box_faces = [&](std::size_t seed) {
    const double half = 0.5 * grid.h, area = dimension == 3 ? grid.h * grid.h : grid.h;
    for (int d = 0; d < dimension; ++d) {
      for (const double side : {-1.0, 1.0}) {
        Vector3 X = grid.X[seed];
        X[d] += side * half;
        const double edge = side < 0 ? grid.lower[of_axis(d)] : grid.upper[of_axis(d)];
        if (std::abs(X[d] - edge) > near_surface * grid.h) continue;
        faces.push_back({seed, X, side * Vector3::Unit(d), area});
      }
    }
  };
  const auto add_ring_faces = [&](std::size_t seed) {
    const Vector3 N = grid.X[seed].normalized();
    const double angle = 2 * std::numbers::pi / grid.cells[1];
    const auto row = static_cast<std::size_t>(grid.cells[0]);
    if (seed % row == 0) faces.push_back({seed, grid.ring->inner * N, -N, grid.ring->inner * angle});
    if (seed % row == row - 1) faces.push_back({seed, grid.ring->outer * N, N, grid.ring->outer * angle});
  };
  for (std::size_t k = 0; k < grid.size(); ++k) grid.ring ? add_ring_faces(k) : add_box_faces(k);
  return faces;
}

ExportedGrid ring_grid_of(double h, const Annulus& ring, double density, SeedPlace place) {
  constexpr double whole = 1e-6;
  constexpr double most_cells = 1e5;  ///< along each direction
  const double width = ring.outer - ring.inner, across = width / h;
  const double around = std::round(std::numbers::pi * (ring.inner + ring.outer) / h);
  if (across > most_cells || around > most_cells)
    throw InputError({}, "--grids", rounded_text(h, 6) + " m makes more than 100,000 cells around the ring");
  if (std::abs(across - std::round(across)) > whole * std::max(across, 1.0) || std::round(across) < 1)
    throw InputError({}, "--grids",
                     rounded_text(h, 6) + " m does not divide the width of the ring, " + rounded_text(width, 6) + " m");
  const bool nodes = place == SeedPlace::nodes;
  ExportedGrid grid;
  grid.h = h, grid.folder = "h_" + rounded_text(h, 6), grid.ring = ring;
  grid.cells = {static_cast<int>(std::round(across)), static_cast<int>(around), 1};
  grid.lower = {-ring.outer, -ring.outer, 0}, grid.upper = {ring.outer, ring.outer, 0};
  const double angle = 2 * std::numbers::pi / grid.cells[1];
  for (int j = 0; j < grid.cells[1]; ++j) {
    for (int i = 0; i < grid.cells[0] + (nodes ? 1 : 0); ++i) {
      const double share = (i + (nodes ? 0.0 : 0.5)) / grid.cells[0];
      const double R = ring.inner * (1 - share) + ring.outer * share;
      grid.X.push_back(at_polar(R, (j + (nodes ? 0.0 : 0.5)) * angle));
      grid.volume.push_back(R * angle * width / grid.cells[0]);  // of a sector: exact
      grid.id.push_back(static_cast<std::int64_t>(grid.id.size()) + 1);
    }
  }
  if (nodes) grid.volume = nodal_areas(mesh_of(grid, 2));
  for (const double volume : grid.volume) grid.mass.push_back(density * volume);
  return grid;
}

}  // namespace assay::drivers
