// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/export/grids.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/scene/body_box.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/text/numbers.hpp"
#include "harness/motion/kinds/vortex3d.hpp"
#include "harness/numeric/norms.hpp"

namespace assay::drivers {

namespace {

constexpr double margin = 1.2;  ///< of the box around a body that turns, times its radius
constexpr double whole = 1e-6;  ///< of the number of cells along an edge
constexpr std::size_t most_seeds = 50'000'000;
constexpr int plane_cells = 32, space_cells = 8;  ///< along the longest edge, of the coarsest grid
constexpr int ring_cells = 8;                     ///< across a ring, likewise
constexpr std::size_t most_grids = 12;

std::size_t axis(int d) { return static_cast<std::size_t>(d); }

/// Around all bodies of revolution, with a margin.
ExportedBody box_around_turning(const Vortex3d& motion) {
  Vector3 lower = Vector3::Constant(HUGE_VAL), upper = -lower;
  for (const Revolution& one : motion.all()) {
    const Vector3 half = one.half_box();
    lower = lower.cwiseMin(one.center - half), upper = upper.cwiseMax(one.center + half);
  }
  ExportedBody body{.may_grow = true};
  for (int d = 0; d < 3; ++d) {
    const double middle = 0.5 * (lower[d] + upper[d]), half = 0.5 * margin * (upper[d] - lower[d]);
    body.lower[axis(d)] = middle - half, body.upper[axis(d)] = middle + half;
  }
  return body;
}

ExportedBody box_around_ring(const Scene& scene) {
  if (scene.body.domain == Body::Domain::ring) {
    const double half = margin * ring_of(scene.motion)->outer;
    return {{-half, -half, 0}, {half, half, 0}, true};
  }
  const Box given = body_box(scene);  // which the reader has seen to hold the ring
  return {{given.lower[0], given.lower[1], 0}, {given.upper[0], given.upper[1], 0}};
}

double longest_edge(const ExportedBody& body) {
  double edge = 0;
  for (std::size_t d = 0; d < 3; ++d) edge = std::max(edge, body.upper[d] - body.lower[d]);
  return edge;
}

/// Whole cells along an edge.
int cells_along(double h, const ExportedBody& body, std::size_t d) {
  const double cells = (body.upper[d] - body.lower[d]) / h;
  const double rounded = std::round(cells);
  if (std::abs(cells - rounded) <= whole * std::max(rounded, 1.0) && rounded >= 1 && rounded < 1e6)
    return static_cast<int>(rounded);
  if (body.may_grow && cells < 1e6) return static_cast<int>(std::ceil(cells));
  throw InputError({}, "--grids",
                   rounded_text(h, 6) + " m does not divide the edge of the body from " +
                       rounded_text(body.lower[d], 6) + " to " + rounded_text(body.upper[d], 6) + " m");
}

/// Seeds in each cell, so many along an edge of it; 0: at each node.
void put_seeds(ExportedGrid& grid, int dimension, double density, int in_cell) {
  const bool nodes = in_cell == 0;
  const double edge = nodes ? grid.h : grid.h / in_cell;
  std::array<int, 3> points = grid.cells;
  for (std::size_t d = 0; d < axis(dimension); ++d) points[d] = nodes ? points[d] + 1 : points[d] * in_cell;
  for (int k = 0; k < points[2]; ++k) {
    for (int j = 0; j < points[1]; ++j) {
      for (int i = 0; i < points[0]; ++i) {
        const std::array<int, 3> at{i, j, k};
        Vector3 X = Vector3::Zero();
        double volume = 1;
        for (std::size_t d = 0; d < axis(dimension); ++d) {
          // from the nearer end, so that the seeds are as symmetric as the box
          const double share = nodes ? 1.0 * at[d] / grid.cells[d] : (at[d] + 0.5) / points[d];
          X[static_cast<int>(d)] = grid.lower[d] * (1 - share) + grid.upper[d] * share;
          volume *= nodes && (at[d] == 0 || at[d] == grid.cells[d]) ? 0.5 * edge : edge;
        }
        grid.id.push_back(static_cast<std::int64_t>(grid.id.size()) + 1);
        grid.X.push_back(X);
        grid.volume.push_back(volume), grid.mass.push_back(density * volume);
      }
    }
  }
}

}  // namespace

ExportedBody exported_body(const Scene& scene, int dimension) {
  if (scene.body.initial_velocity)
    refuse(scene, "body.initial_velocity", "a body that is left to itself has no exact solution to export");
  if (scene.frame) refuse(scene, "frame", "export writes problems in the body's own frame: leave the section out");
  if (scene.body.periodic != Body::Periodic::none)
    refuse(scene, "body.periodic", "export knows no bodies that repeat: leave the key out");
  if (const auto* turning = scene.motion.as<Vortex3d>()) return box_around_turning(*turning);
  if (is_vortex(scene.motion)) return box_around_ring(scene);
  if (const auto ring = ring_of(scene.motion))
    return {{-ring->outer, -ring->outer, 0}, {ring->outer, ring->outer, 0}, false, ring};
  const Box box = body_box(scene);
  if (dimension == 2) return {{box.lower[0], box.lower[1], 0}, {box.upper[0], box.upper[1], 0}};
  const std::size_t deep = scene.body.lower.size() == 3 ? 2 : 1;  // or as deep as it is high
  return {{box.lower[0], box.lower[1], scene.body.lower[deep]}, {box.upper[0], box.upper[1], scene.body.upper[deep]}};
}

std::vector<double> spacings_of_ladder(const std::string& given, const Scene& scene, const ExportedBody& body,
                                       int dimension) {
  std::vector<double> h;
  if (given.empty()) {
    const double own = body.ring ? (body.ring->outer - body.ring->inner) / ring_cells
                                 : longest_edge(body) / (dimension == 3 ? space_cells : plane_cells);
    const double coarsest = scene.grid ? 2 * scene.grid->spacing : own;
    return {coarsest, coarsest / 2, coarsest / 4};
  }
  for (const std::string& part : split(given, ',')) {
    const auto value = parse_number(stripped(part));
    if (!value || !(*value > 0) || !std::isfinite(*value))
      throw InputError({}, "--grids", "'" + one_line(part, 40) + "' is no spacing above 0");
    h.push_back(*value);
  }
  if (h.size() > most_grids)
    throw InputError({}, "--grids",
                     "at most " + std::to_string(most_grids) + " grids, found " + std::to_string(h.size()));
  std::ranges::sort(h, std::greater());
  if (std::ranges::adjacent_find(h) != h.end()) throw InputError({}, "--grids", "a spacing stands there twice");
  return h;
}

ExportedGrid grid_of(double h, const ExportedBody& body, int dimension, double density, SeedPlace place) {
  if (body.ring) return ring_grid_of(h, *body.ring, density, place);
  ExportedGrid grid;
  grid.h = h, grid.folder = "h_" + rounded_text(h, 6);
  const bool both = place == SeedPlace::body_centred && dimension == 3;
  const int in_cell = place == SeedPlace::nodes ? 0 : place == SeedPlace::two_by_two ? 2 : 1;
  double seeds = both ? 2 : 1;
  for (std::size_t d = 0; d < axis(dimension); ++d) {
    grid.cells[d] = cells_along(h, body, d);
    const double middle = 0.5 * (body.lower[d] + body.upper[d]), half = 0.5 * h * grid.cells[d];
    grid.lower[d] = middle - half, grid.upper[d] = middle + half;
    seeds *= in_cell == 0 ? grid.cells[d] + 1 : grid.cells[d] * in_cell;
  }
  if (seeds > static_cast<double>(most_seeds))
    throw InputError({}, "--grids",
                     rounded_text(h, 6) + " m makes " + rounded_text(seeds, 3) + " particles, more than " +
                         grouped_text(static_cast<std::int64_t>(most_seeds)));
  put_seeds(grid, dimension, density, in_cell);
  if (both) put_seeds(grid, dimension, density, 0);
  if (both)
    for (std::size_t k = 0; k < grid.size(); ++k) grid.volume[k] *= 0.5, grid.mass[k] *= 0.5;
  return grid;
}

}  // namespace assay::drivers
