// SPDX-License-Identifier: BSD-3-Clause
// The square of the plane as a slab in space: about each axis it must turn as the square does.

#if ASSAY_DIMENSION == 3
#include <algorithm>
#include <cmath>

#include "harness/numeric/norms.hpp"
#include "mpm/patch/rotation.hpp"
#include "mpm/seeding/lattice.hpp"

namespace assay::mpm {

namespace {

constexpr int slab_cells = 8;  ///< across
/// Of h, by which the particles are off the middle of their cells along the axis, so that no two weights agree.
constexpr double off_middle = 0.31830988618379067;

Axis unit_along(std::size_t a) {
  Axis n{};
  n[a] = 1;
  return n;
}

/// One cell and one particle thick along axis a, between periodic ends.
Setup<3> slab_setup(const Method& method, const Bench<3>& bench, std::size_t a) {
  Setup<3> setup = forced(patch_setup(method, bench, slab_cells));
  const double h = setup.grid.spacing;
  Vec<3> lower, upper;
  std::array<int, 3> per_cell;
  lower.fill(-0.5), upper.fill(0.5), per_cell.fill(2);
  lower[a] = 0, upper[a] = h, per_cell[a] = 1;
  setup.seeds = cartesian_lattice<3>(lower, upper, h, per_cell, [](const auto&) { return Fate::stepped; });
  for (double& X : setup.seeds.X[a]) X += off_middle * h;
  setup.grid = grid_around<3>(lower, upper, h, slab_cells);
  constexpr int room = 5;  // cells on either side, beyond the widest function
  setup.grid.first[a] = -room, setup.grid.count[a] = 2 * room + 2;
  setup.ends[a] = {0.0, h, true};
  return setup;
}

/// The particles of a lattice in the order of their places along these axes.
template <int Dim>
std::vector<std::size_t> by_place(const State<Dim>& s, const std::array<std::size_t, 3>& axes, double distance) {
  std::vector<std::pair<std::array<long, Dim>, std::size_t>> places(s.particles);
  for (std::size_t p = 0; p < s.particles; ++p) {
    for (std::size_t d = 0; d < Dim; ++d)
      places[p].first[d] = std::lround(4 / distance * s.column(Column::reference_position, axes[d])[p]);
    places[p].second = p;
  }
  std::sort(places.begin(), places.end());
  std::vector<std::size_t> order;
  for (const auto& place : places) order.push_back(place.second);
  return order;
}

}  // namespace

template <int Dim>
double difference(const State<Dim>& one, const State<3>& other, const std::array<std::size_t, 3>& axes,
                  double distance) {
  const auto of_one = by_place<Dim>(one, {0, 1, 2}, distance), of_other = by_place<3>(other, axes, distance);
  double largest = of_one.size() == of_other.size() ? 0 : INFINITY;
  for (std::size_t k = 0; k < of_one.size() && std::isfinite(largest); ++k) {
    const std::size_t q = of_one[k], p = of_other[k];
    for (std::size_t i = 0; i < 3; ++i) {
      const double x =
          i < Dim ? one.column(Column::position, i)[q] : other.column(Column::reference_position, axes[i])[p];
      largest = larger(largest, std::abs(other.column(Column::position, axes[i])[p] - x));
      for (std::size_t j = 0; j < 3; ++j) {
        const bool is_given = i < Dim && j < Dim;
        const double F = is_given ? one.column(Column::deformation_gradient, i * Dim + j)[q] : i == j ? 1 : 0;
        largest = larger(largest, std::abs(other.column(Column::deformation_gradient, 3 * axes[i] + axes[j])[p] - F));
      }
    }
  }
  return largest;
}

std::vector<check::TestResult> turning_slabs(const Method& method, const Bench<3>& bench) {
  const Bench<2> plane{.material = bench.material, .density = bench.density, .wave_speed = bench.wave_speed};
  const double step = time_step(plane, slab_cells, square_speed);
  const auto square =
      turn_body(forced(patch_setup(method, plane, slab_cells)), plane, unit_along(2), square_turn, step);
  std::vector<check::TestResult> results;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto slab = turn_body(slab_setup(method, bench, a), bench, unit_along(a), square_turn, step);
    Figure figure{INFINITY, "unstable at t = " + digits(slab.t) + " s, the square at " + digits(square.t) + " s"};
    if (!slab.finding && !square.finding) {
      figure.measure = difference(square.state(), slab.state(), {(a + 1) % 3, (a + 2) % 3, a}, 0.5 / slab_cells);
      figure.sentence = "a slab across this axis turns about it as a square in the plane, but for " +
                        digits(figure.measure) + " m in places, or in F";
    }
    results.push_back(judged(method, std::string("slab.") + "xyz"[a], figure, same_motion,
                             "a slab in space moves otherwise than a square in the plane"));
  }
  return results;
}

template double difference(const State<2>&, const State<3>&, const std::array<std::size_t, 3>&, double);
template double difference(const State<3>&, const State<3>&, const std::array<std::size_t, 3>&, double);

}  // namespace assay::mpm
#endif
