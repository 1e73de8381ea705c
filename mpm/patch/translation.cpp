// SPDX-License-Identifier: BSD-3-Clause
// A free elastic body that flies: nothing but rounding may happen to it.
#include <algorithm>
#include <cmath>

#include "harness/numeric/norms.hpp"
#include "mpm/patch/patch.hpp"

namespace assay::mpm {

namespace {

constexpr double translation_threshold = 1e-12;  ///< rounding: at most 6e-14 is found
/// sqrt 2, -1/sqrt 3, sqrt 5 / 3 [m/s]
constexpr std::array<double, 3> aslant{1.4142135623730951, -0.57735026918962573, 0.74535599249992990};
constexpr double cells_crossed = 3.7;

/// How a body flies.
template <int Dim>
struct Course {
  Vec<Dim> velocity{};  ///< [m/s]
  Vec<Dim> moved{};     ///< before it starts [h]
  double dt = 0;        ///< [s]
  int steps = 0;
};

struct Flight {
  double velocity = 0, deformation = 0, momentum = 0;  ///< over |v|; of F; over the momentum
  double place = 0;                                    ///< of particles and corners, over h
  std::optional<Finding> finding;
  int steps = 0;
};

/// Of a body that has flown straight for t.
template <int Dim>
double misplacement(const State<Dim>& s, const Vec<Dim>& velocity, double t) {
  const Vec<Dim>& half = s.setup.seeds.half_size;
  double largest = 0;
  for (std::size_t p = 0; p < s.particles; ++p) {
    for (std::size_t d = 0; d < Dim; ++d) {
      const double x = s.column(Column::reference_position, d)[p] + velocity[d] * t;
      largest = larger(largest, std::abs(s.column(Column::position, d)[p] - x));
      for (std::size_t c = 0; s.has(Column::corners) && c < 1 << Dim; ++c) {
        const double corner = s.column(Column::corners, Dim * c + d)[p];
        largest = larger(largest, std::abs(corner - x - ((c >> d & 1) ? half[d] : -half[d])));
      }
    }
  }
  return largest / s.setup.grid.spacing;
}

template <int Dim>
Flight fly(const Method& method, const Bench<Dim>& bench, int across, const Course<Dim>& course) {
  Setup<Dim> setup = patch_setup(method, bench, across);
  for (std::size_t d = 0; d < Dim; ++d) {
    for (double& X : setup.seeds.X[d]) X += course.moved[d] * setup.grid.spacing;
  }
  Simulation<Dim> simulation(setup, bench.passes(setup));
  State<Dim>& s = simulation.state();
  for (std::size_t d = 0; d < Dim; ++d) std::fill_n(s.column(Column::velocity, d), s.particles, course.velocity[d]);
  const Momentum<Dim> before = momentum_of(s);
  const double speed = length_of<Dim>(course.velocity);
  Flight flight;
  flight.steps = course.steps;
  for (int k = 0; k < flight.steps; ++k) {
    flight.finding = simulation.step(k * course.dt, course.dt);
    if (flight.finding) return flight;
  }
  for (std::size_t p = 0; p < s.particles; ++p) {
    for (std::size_t d = 0; d < Dim; ++d) {
      const double v = s.column(Column::velocity, d)[p];
      flight.velocity = larger(flight.velocity, std::abs(v - course.velocity[d]) / speed);
    }
    for (int c = 0; c < Dim * Dim; ++c) {
      const double exact = c % (Dim + 1) == 0 ? 1 : 0;
      flight.deformation = larger(flight.deformation, std::abs(s.column(Column::deformation_gradient, c)[p] - exact));
    }
  }
  flight.place = misplacement<Dim>(s, course.velocity, flight.steps * course.dt);
  const Momentum<Dim> after = momentum_of(s);
  for (std::size_t d = 0; d < Dim; ++d) {
    flight.momentum = larger(flight.momentum, std::abs(after.linear[d] - before.linear[d]) / before.scale);
  }
  return flight;
}

double error_of(const Flight& flight) {
  if (flight.finding) return INFINITY;
  return larger(larger(flight.velocity, flight.deformation), larger(flight.momentum, flight.place));
}

std::string told(const Flight& flight) {
  if (flight.finding) return "ends before its time: " + flight.finding->reason;
  return std::to_string(flight.steps) + " steps: velocity off by " + digits(flight.velocity) + ", F by " +
         digits(flight.deformation) + ", momentum by " + digits(flight.momentum) + ", places by " +
         digits(flight.place) + " h";
}

/// Particles on lines between cells, in space on faces, on crossings of these, and such as arrive at both, again and
/// again. The lattice has its particles a quarter of a cell from the lines.
template <int Dim>
std::vector<std::pair<std::string, Course<Dim>>> courses_on_lines(const Bench<Dim>& bench, int across) {
  constexpr double quarter = 0.25, slow = 1e-3;
  const double still = time_step(bench, across, slow);
  // so fast that the waves hardly move in a step
  const double speed = 8 * bench.wave_speed, dt = quarter / (across * speed);
  constexpr int steps = 11;  // through nearly three cells
  if constexpr (Dim == 2) {
    return {{"from lines", {{slow, -slow}, {quarter, 0}, still, 1}},
            {"from lines along the other axis", {{slow, -slow}, {0, -quarter}, still, 1}},
            {"from crossings", {{slow, slow}, {quarter, quarter}, still, 1}},
            {"across lines", {{speed, 0}, {}, dt, steps}},
            {"backwards across lines", {{0, -speed}, {}, dt, steps}},
            {"from crossing to crossing", {{speed, -speed}, {quarter, -quarter}, dt, steps}}};
  } else {
    return {{"from faces across E_1", {{slow, -slow, slow}, {quarter, 0, 0}, still, 1}},
            {"from faces across E_2", {{slow, -slow, slow}, {0, -quarter, 0}, still, 1}},
            {"from faces across E_3", {{slow, slow, -slow}, {0, 0, quarter}, still, 1}},
            {"from lines along E_1", {{slow, slow, -slow}, {0, quarter, -quarter}, still, 1}},
            {"from lines along E_2", {{slow, slow, slow}, {-quarter, 0, -quarter}, still, 1}},
            {"from crossings", {{slow, slow, slow}, {quarter, quarter, quarter}, still, 1}},
            {"across faces", {{0, 0, speed}, {}, dt, steps}},
            {"backwards across faces", {{0, -speed, 0}, {}, dt, steps}},
            {"from crossing to crossing", {{speed, -speed, speed}, {quarter, -quarter, quarter}, dt, steps}}};
  }
}

}  // namespace

template <int Dim>
std::vector<check::TestResult> translation(const Method& method, const Bench<Dim>& bench) {
  const int across = cells_across(bench);
  Vec<Dim> velocity;
  std::copy_n(aslant.begin(), Dim, velocity.begin());
  const double speed = length_of<Dim>(velocity), dt = time_step(bench, across, speed);
  const int steps = static_cast<int>(std::ceil(cells_crossed / (across * aslant[0] * dt)));
  const Flight flight = fly<Dim>(method, bench, across, {velocity, {}, dt, steps});
  const std::string way = flight.finding ? "" : "through " + digits(cells_crossed) + " cells in ";
  const Figure plain{error_of(flight), way + told(flight)};
  Figure lines{-1, {}};
  constexpr int few = Dim == 2 ? 8 : 4;  // cells: what happens on a line happens on each
  for (const auto& [what, course] : courses_on_lines(bench, few)) {
    const Flight on_lines = fly(method, bench, few, course);
    const double error = error_of(on_lines);
    if (!std::isnan(lines.measure) && !(error <= lines.measure)) lines = {error, what + ", " + told(on_lines)};
  }
  return {
      judged(method, "translation", plain, translation_threshold, "uniform motion disturbed"),
      judged(method, "translation.lines", lines, translation_threshold, "particles on lines disturb uniform motion")};
}

template std::vector<check::TestResult> translation(const Method&, const Bench<ASSAY_DIMENSION>&);

}  // namespace assay::mpm
