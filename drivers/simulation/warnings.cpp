// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/warnings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "drivers/scene/body_box.hpp"
#include "drivers/simulation/time_steps.hpp"
#include "drivers/simulation/units_hint.hpp"
#include "drivers/text/numbers.hpp"
#include "harness/check/march.hpp"
#include "harness/motion/kinds/deformation_table.hpp"
#include "harness/motion/kinds/vortex.hpp"
#include "harness/motion/kinds/vortex3d.hpp"

namespace assay::drivers {

namespace {

/// By the fastest wave, until the end of the run.
template <int Dim>
double crossings(const ProblemIn<Dim>& problem) {
  const auto sides = sides_of_body(problem);
  return problem.wave_speed * problem.scene.time.end / *std::max_element(sides.begin(), sides.end());
}

std::string long_step_sentence(const PosedScene& problem) {
  const double courant = problem.dt * fastest_signal(problem) / problem.scene.grid->spacing;
  const auto fixed = problem.scene.time.fixed_step();
  if (!fixed || courant <= 1) return "";
  return fixed->says + problem.scene.units.text(problem.dt, "s", 3) + " is " + rounded_text(courant, 3) +
         " times the time in which the fastest wave crosses a cell: the run is likely to become unstable";
}

template <int Dim>
std::string stress_at_rest_sentence(const ProblemIn<Dim>& problem) {
  constexpr double significant = 1e-6;  // of rho c^2
  if (problem.setup.hold_outside || problem.setup.traction) return "";
  const auto& direction = problem.setup.material_direction;
  const Tensor I = Tensor::Identity();
  double stress = 0;
  try {
    const std::vector<double> state =
        check::state_at_rest(*problem.material, 0, Vector3(direction[0], direction[1], direction[2]));
    stress = check::stepped(*problem.material, 0, problem.dt, I, I, state).cauchy.cwiseAbs().maxCoeff();
  } catch (const std::runtime_error&) {  // the run itself will tell
  }
  if (!(stress > significant * problem.setup.density * problem.wave_speed * problem.wave_speed)) return "";
  return "the material has a stress of " + problem.scene.units.text(stress, "Pa", 3) +
         " at rest, which free faces cannot balance: the body will not follow the motion there";
}

/// The largest of |F''| behind a row less that before it [1/s^2].
double largest_jump(const DeformationTable& table, double end) {
  constexpr double before = 1e-7;  // of the interval between two rows
  double largest = 0;
  const std::vector<double>& times = table.times();
  for (std::size_t i = 1; i + 1 < times.size() && times[i] < end; ++i) {
    const double left = times[i] - before * (times[i] - times[i - 1]);
    for (const Vector3& X : {Vector3(1, 0, 0), Vector3(0, 1, 0)}) {
      largest = std::max(largest, (table.at(X, times[i]).a - table.at(X, left).a).norm());
    }
  }
  return largest;
}

/// A step in which F'' jumps takes one of its two values for the whole of it: half a step of the jump stays in the
/// velocity on average, and grows in the displacement.
std::string jump_sentence(const PosedScene& problem) {
  constexpr double noticeable = 0.05;
  const auto* table = problem.scene.motion.as<DeformationTable>();
  if (!table || !problem.compared) return "";
  const double end = problem.scene.time.end, jump = largest_jump(*table, end);
  const auto fixed = problem.scene.time.fixed_step();
  double largest = 0;
  for (const Tensor& F : table->rows()) largest = std::max(largest, (F - Tensor::Identity()).norm());
  const double share = 0.5 * problem.dt * jump * end / largest;
  if (!(share > noticeable)) return "";
  const Units& units = problem.scene.units;
  return "the body force jumps at the rows of motion.path, by up to " +
         rounded_text(units.scale("1/s^2").from_si(jump), 3) + " /" + units.time + "^2 in F'': steps of " +
         units.text(problem.dt, "s", 3) + " may turn that into an error of " + rounded_text(100 * share, 2) +
         " % of the motion; take " + (fixed ? fixed->shorter : "a smaller method.courant") +
         ", or motion.interpolation: spline";
}

std::string late_snapshots_sentence(const PosedScene& problem) {
  const auto& from = problem.scene.output.each_step_from;
  const double end = problem.scene.time.end;
  if (!from || *from <= end) return "";
  const Units& units = problem.scene.units;
  return "output.each_step_from = " + units.text(*from, "s", 6) + " lies beyond time.end = " + units.text(end, "s", 6) +
         ": no step is written for it";
}

/// A density in t/mm^3 beside a stiffness in Pa: no solid has such waves, in m/s or in mm/s.
std::string density_sentence(const PosedScene& problem) {
  constexpr double least = 1e-10, most = 1e-7, kg_per_m3 = 1e12, fastest = 1e8;
  const double density = problem.scene.material.density;
  if (!(density >= least && density <= most) || !(problem.wave_speed > fastest)) return "";
  const Units& units = problem.scene.units;
  return "material.density = " + units.text(density, "kg/m^3", 6) + " and the stiffness make waves of " +
         units.text(problem.wave_speed, "m/s", 3) + ", which no solid has; in t/mm^3 the density would be " +
         rounded_text(density * kg_per_m3, 6) +
         " kg/m^3: units are SI, or those of one system, such as t, mm, s and MPa, throughout";
}

/// The thinnest body of revolution: where the tube of a torus, a ball or a drum has few cells, b changes within each.
std::string thin_body_sentence(const Scene& scene) {
  constexpr double enough = 4;  // cells: with 2 errors are 2.6 times the motion, with 4 a third of it (measured)
  const auto* vortices = scene.motion.as<Vortex3d>();
  if (!vortices) return "";
  double thickness = HUGE_VAL;
  for (const Revolution& body : vortices->all()) {
    thickness = std::min(thickness, 2 * body.radius);
    if (body.profile == Revolution::Profile::drum) thickness = std::min(thickness, 2 * body.reach()[1]);
  }
  const double cells = thickness / scene.grid->spacing;
  if (!(cells < enough * (1 - 1e-9))) return "";
  const bool at_points = scene.force.evaluation == mpm::Evaluation::point;
  return "grid.spacing: a vortex is " + scene.units.text(thickness, "m", 3) + " thick, which is " +
         rounded_text(cells, 2) + " cells: errors may be as large as the motion" +
         (at_points ? "; force.evaluation: domain_average lessens them" : "");
}

template <int Dim>
std::string coarse_grid_sentence(const ProblemIn<Dim>& problem) {
  const auto body = body_box<Dim>(problem.scene);
  const double h = problem.scene.grid->spacing;
  double side = HUGE_VAL;
  for (std::size_t d = 0; d < Dim; ++d) side = std::min(side, body.upper[d] - body.lower[d]);
  if (!(side > 0 && h > (1 + 1e-9) * side)) return "";
  const Units& units = problem.scene.units;
  return "grid.spacing = " + units.text(h, "m", 3) + " is larger than the body, which is " + units.text(side, "m", 3) +
         " across: no cell is filled, and errors may be as large as the motion";
}

/// A quadratic spline ends in the middle of a cell. A particle there gives the node beyond it neither mass nor stress,
/// and the face beside it gives it a force.
template <int Dim>
std::string spline_end_sentence(const ProblemIn<Dim>& problem) {
  const mpm::Setup<Dim>& setup = problem.setup;
  if (!setup.traction || setup.has_virtual_stress() || !setup.method.is_total() ||
      setup.method.basis != mpm::Basis::bspline2)
    return "";
  for (std::size_t d = 0; d < Dim && setup.seeds.size() > 0; ++d) {
    const auto [least, most] = std::minmax_element(setup.seeds.X[d].begin(), setup.seeds.X[d].end());
    const auto ends_at = [&](double x, bool is_free) {
      const double cells = x / setup.grid.spacing - setup.grid.offset[d];
      return is_free && std::abs(cells - std::floor(cells) - 0.5) < 1e-6;
    };
    if (!ends_at(*least, !setup.ends[d].lower) && !ends_at(*most, !setup.ends[d].upper)) continue;
    return "body.per_cell: the outermost particles along " + std::string(1, "XYZ"[d]) +
           " are in the middle of a cell. A quadratic spline ends there, and the traction of the face loads it: the "
           "error will be a few per cent of the motion on any grid. Take an even number per cell to avoid it";
  }
  return "";
}

/// The period in which a wave crosses the body `wanted` times, of a ring's motion with more than `most` crossings.
template <int Dim>
std::optional<double> period_with(const ProblemIn<Dim>& problem, double most, double wanted) {
  const bool is_set = problem.scene.time.fixed_step().has_value();
  const Motion& motion = problem.scene.motion;
  if (!problem.compared || is_set || !(ring_of(motion) || motion.as<Vortex3d>())) return std::nullopt;
  const double found = crossings(problem);
  return found > most ? std::optional(problem.period() * wanted / found) : std::nullopt;
}

/// The time of the largest |g| in 0 .. end: at a reversal or at an end.
double time_of_peak(const Amplitude& amplitude, double end) {
  double peak = end;
  for (const double t : amplitude.reversals(end)) {
    if (std::abs(amplitude.at(t).value) > std::abs(amplitude.at(peak).value)) peak = t;
  }
  return peak;
}

}  // namespace

template <int Dim>
std::optional<double> shorter_period(const ProblemIn<Dim>& problem) {
  return period_with(problem, 1000, 30);
}

// The paper's vortex has two crossings.
template <int Dim>
std::optional<double> period_of_few_waves(const ProblemIn<Dim>& problem) {
  return period_with(problem, 10, 2);
}

std::string period_text(const PosedScene& problem, double period) {
  const Scene& scene = problem.scene;
  const Scale time = scene.units.scale("s");
  std::string text = rounded_text(time.from_si(period), 2);
  if (!scene.places.contains("time.end")) return text;
  return text + " with time.end: " + rounded_text(time.from_si(period * scene.time.end / problem.period()), 2);
}

template <int Dim>
std::string long_motion_sentence(const ProblemIn<Dim>& problem) {
  const std::optional<double> shorter = shorter_period(problem);
  if (!shorter) return "";
  return "a wave crosses the body " + rounded_text(crossings(problem), 2) + " times during the motion: the run takes " +
         rounded_text(static_cast<double>(problem.steps), 2) +
         " steps, and errors of all these waves add up. motion.period: " + period_text(problem, *shorter) +
         " shortens the run, and " + period_text(problem, *period_of_few_waves(problem)) +
         " makes the waves as few as in the paper's vortex";
}

std::string swing_sentence(const Scene& scene) {
  const auto* table = scene.motion.as<DeformationTable>();
  if (!table || table->interpolation() != Interpolation::spline) return "";
  const auto far = table->farthest_departure();
  if (!far) return "";
  const std::string name = "F" + std::to_string(far->component / 3 + 1) + std::to_string(far->component % 3 + 1);
  return "motion.interpolation: the spline takes " + name + " to " + rounded_text(far->value, 6) +
         " at t = " + scene.units.text(far->x, "s", 6) + ", " + rounded_text(far->by, 3) + " beyond the rows there, " +
         rounded_text(far->lower, 6) + " and " + rounded_text(far->upper, 6) + ": monotone stays between them";
}

template <int Dim>
std::vector<std::string> warnings_of(const ProblemIn<Dim>& problem) {
  std::vector<std::string> all{long_motion_sentence(problem),
                               long_step_sentence(problem),
                               stress_at_rest_sentence(problem),
                               swing_sentence(problem.scene),
                               jump_sentence(problem),
                               late_snapshots_sentence(problem),
                               density_sentence(problem),
                               coarse_grid_sentence(problem),
                               spline_end_sentence(problem),
                               thin_body_sentence(problem.scene),
                               units_hint_for_many_steps(problem)};
  std::erase(all, "");
  return all;
}

void warn_of_stillness(const PosedScene& problem, double largest_displacement, Result& result) {
  constexpr double rounding = 1e-12;  // of a cell
  const bool ended = !result.history.empty() && result.history.back().t >= 0.5 * problem.scene.time.end;
  if (!ended || problem.scene.frame || largest_displacement > rounding * problem.scene.grid->spacing) return;
  result.warnings.push_back(
      "the exact displacement is zero whenever the error is sampled, and a method that does not move the body passes: "
      "give the motion an amplitude");
}

std::vector<Interval> zones_beyond(const Vortex& vortex, std::span<const double> fronts) {
  Interval first{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  for (const double front : fronts) {
    if (front < 0) first.lower = std::max(first.lower, front);
    if (front > 0) first.upper = std::min(first.upper, front);
  }
  std::vector<double> edges{vortex.inner};
  const RadiiOfXi radii_of_xi(vortex);
  for (const double front : {first.lower, first.upper}) {
    for (const double R : radii_of_xi(front)) edges.push_back(R);
  }
  edges.push_back(vortex.outer);
  std::sort(edges.begin(), edges.end());
  std::vector<Interval> zones;
  for (std::size_t k = 0; k + 1 < edges.size(); ++k) {
    const double xi = vortex.profile(0.5 * (edges[k] + edges[k + 1])).xi;
    if (xi < first.lower || xi > first.upper) zones.push_back({edges[k], edges[k + 1]});
  }
  return zones;
}

std::optional<RimFigures> rim_of(const Response& response, const Vortex& vortex, double h, double end) {
  const Sheet* sheet = response.sheet();
  if (!sheet || !sheet->has_kinks()) return std::nullopt;
  const std::vector<double> fronts = sheet->isochrone(time_of_peak(vortex.amplitude, end)).kinks();
  RimFigures rim{std::numeric_limits<double>::infinity(), 0};
  for (const Interval& zone : zones_beyond(vortex, fronts)) rim.width = std::min(rim.width, zone.upper - zone.lower);
  if (!std::isfinite(rim.width)) return std::nullopt;
  rim.cells = rim.width / h;
  return rim;
}

std::string narrow_rim_sentence(const RimFigures& rim, const Units& units) {
  if (rim.cells >= fewest_rim_cells) return {};
  return "the plastic rim is " + units.text(rim.width, "m", 3) + " wide, " + rounded_text(rim.cells, 2) +
         " cells: the grid does not resolve less than 2 cells; take a smaller grid.spacing";
}

template std::optional<double> shorter_period(const ProblemIn<2>&);
template std::optional<double> period_of_few_waves(const ProblemIn<2>&);
template std::string long_motion_sentence(const ProblemIn<2>&);
template std::vector<std::string> warnings_of(const ProblemIn<2>&);
template std::optional<double> shorter_period(const ProblemIn<3>&);
template std::optional<double> period_of_few_waves(const ProblemIn<3>&);
template std::string long_motion_sentence(const ProblemIn<3>&);
template std::vector<std::string> warnings_of(const ProblemIn<3>&);

}  // namespace assay::drivers
