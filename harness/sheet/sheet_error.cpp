// SPDX-License-Identifier: BSD-3-Clause
// The error of a sheet, from histories off its nodes, and what it does to the body force that is made of the sheet.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "harness/history/history.hpp"
#include "harness/numeric/central_difference.hpp"
#include "harness/numeric/norms.hpp"
#include "harness/sheet/sheet.hpp"
#include "harness/sheet/sheet_build.hpp"

namespace assay {

namespace {

/// Of a band: irrational, so that no node family has them. Near its ends the motion of breaks is hardest to follow.
constexpr double places_in_s[] = {0.0971, 0.2113, 0.4603, 0.7274, 0.9123};
constexpr double places_in_t[] = {0.0937, 0.5361, 0.8999};  ///< of a stretch
/// Step of the differences, of the distance to the band's nearest end: a shorter one has less of a truncation error and
/// more of the histories' own, which is large in increments.
constexpr double stencil_of_rates = 0.03, stencil_of_increments = 0.06;
constexpr double narrow_share = 1e-4;       ///< of the range of xi
constexpr std::size_t most_stretches = 16;  ///< of a long history that are looked at
constexpr int reach = central_reach;

/// Where a band is looked at: nine neighbouring histories at ascending times.
struct Stencil {
  const BandSeries* table;
  double xi, step;
  std::vector<double> times;
  std::vector<Tensor> tau;  ///< [row * 9 + neighbour]
  std::int64_t calls = 0;
  double error = 0;
};

Stencil lay_out(const BandSeries& table, double place, double share) {
  const Band& band = table.band();
  Stencil stencil{&table, band.map.xi_of(place), 0, {}, {}, 0, 0};
  stencil.step = share * std::min(stencil.xi - band.map.xi.lower, band.map.xi.upper - stencil.xi);
  const std::size_t stretches = band.stretches(), stride = (stretches + most_stretches - 1) / most_stretches;
  for (std::size_t i = 0; i < stretches; i += stride) {
    const double begin = table.break_at(i, place), width = table.break_at(i + 1, place) - begin;
    for (const double u : places_in_t) stencil.times.push_back(begin + u * width);
  }
  return stencil;
}

/// Along its middle by increments, whatever the form of the table; the neighbours by what is the most exact.
void integrate(const Course& increments, const Course& neighbours, const HistoryOptions& options, Stencil& stencil) {
  stencil.tau.resize(stencil.times.size() * 9);
  std::vector<double> times;  // histories do not go back where breaks cross
  for (const double t : stencil.times) times.push_back(std::max(t, times.empty() ? 0 : times.back()));
  for (int k = -reach; k <= reach; ++k) {
    const double xi = stencil.xi + k * stencil.step;
    const Course& course = k == 0 ? increments : neighbours;
    const HistoryTrail trail = follow(course, xi, options, times);
    for (std::size_t row = 0; row < times.size(); ++row) {
      const Tensor F = course.path->deformation_gradient(xi, times[row]);
      stencil.tau[row * 9 + static_cast<std::size_t>(k + reach)] = first_piola_kirchhoff(trail.cauchy(row), F);
    }
    stencil.calls += trail.calls;
    stencil.error = larger(stencil.error, trail.error);
  }
}

/// Whether all nine histories are in one stretch: a difference over a kink says nothing.
bool in_one_stretch(const Stencil& stencil, double t) {
  const auto stretch = [&](int k) {
    return stencil.table->stretch_at(stencil.table->band().map.s_of(stencil.xi + k * stencil.step), t);
  };
  return stretch(-reach) == stretch(reach) && stretch(0) == stretch(reach);
}

void compare(const Stencil& stencil, SheetError& error) {
  for (std::size_t row = 0; row < stencil.times.size(); ++row) {
    const double t = stencil.times[row];
    const Tensor* tau = &stencil.tau[row * 9 + reach];
    Tensor value, slope;
    stencil.table->at(stencil.xi, t, value, slope);
    error.tau_scale = larger(error.tau_scale, largest_of(*tau));
    error.tau = larger(error.tau, largest_of(value - *tau));
    if (!in_one_stretch(stencil, t)) continue;
    const Tensor difference = central_difference([&](int k) { return tau[k]; }, stencil.step);
    error.dtau_scale = larger(error.dtau_scale, largest_of(difference));
    error.dtau = larger(error.dtau, largest_of(slope - difference));
  }
}

/// What follows the last terms of the series, which is largest at the ends of a band and of a stretch, away from the
/// places that are looked at. A derivative multiplies the term of number n by n^2 there. Of d tau / d xi not in bands
/// that are nothing but fronts close to each other. What the series of the breaks leave out is not bounded here but
/// seen at the places: rounding of their times keeps those terms large.
void add_tails(const std::vector<BandSeries>& tables, double range, SheetError& error) {
  constexpr double rest = 4;  // of a series that falls by a quarter from term to term, over its last term
  for (const BandSeries& table : tables) {
    const double n = table.size().nodes_in_xi, width = table.band().map.xi.width(), largest = table.largest();
    error.tau = larger(error.tau, rest * (table.tail_in_xi() + table.tail_in_t()));
    if (!(width > narrow_share * range && largest > 0)) continue;
    const double of_xi = 2 * n * n / width * table.tail_in_xi(), of_t = table.tail_in_t() / largest * table.steepest();
    error.dtau = larger(error.dtau, std::min(of_xi + rest * of_t, error.dtau_scale));
  }
}

constexpr int radii = 64, instants = 32;  ///< at which b is looked at, away from the ring's edges

}  // namespace

SheetError error_of(const std::vector<BandSeries>& tables, const Material& material, const Path& path,
                    const SheetOptions& options, Watch watch, std::int64_t& calls) {
  const Telling telling = watch.value_or(Telling::state);
  const Course increments(material, path, options.end, Form::increments, telling);
  const Course neighbours(material, path, options.end, watch ? Form::increments : Form::automatic, telling);
  const double share = neighbours.by_rate ? stencil_of_rates : stencil_of_increments;
  const HistoryOptions history{.tolerance = std::max(watch ? 1e-12 : 1e-13, 1e-5 * options.tolerance),
                               .watch = watch.has_value()};
  std::vector<Stencil> stencils;
  for (const BandSeries& table : tables) {
    for (const double place : places_in_s) stencils.push_back(lay_out(table, place, share));
  }
  const auto count = static_cast<double>(stencils.size());
  const SheetProgress begun{SheetProgress::Stage::error, 0, count};
  for_each_index(static_cast<int>(stencils.size()),
                 reporting(increments.workers(options.workers), options, begun, count),
                 [&](int k) { integrate(increments, neighbours, history, stencils[static_cast<std::size_t>(k)]); });
  SheetError error;
  double history_error = 0;
  for (const Stencil& stencil : stencils) {
    compare(stencil, error);
    calls += stencil.calls;
    history_error = larger(history_error, stencil.error);
  }
  for (const BandSeries& table : tables) history_error = larger(history_error, table.noise());
  add_tails(tables, path.parameter.width(), error);
  if (error.tau_scale > 0) error.tau /= error.tau_scale;
  if (error.dtau_scale > 0) error.dtau /= error.dtau_scale;
  error.tau += history_error;
  return error;
}

double force_error(const Motion& motion, double density, const Sheet& sheet, double end) {
  const double tau_error = sheet.error().tau * sheet.error().tau_scale;
  const double dtau_error = sheet.error().dtau * sheet.error().dtau_scale;
  const Annulus ring = *ring_of(motion);
  double largest_error = 0, largest_force = 0;
  for (int j = 0; j < instants; ++j) {
    const double t = end * (j + 0.5) / instants;
    const Isochrone isochrone = sheet.isochrone(t);
    for (int i = 0; i < radii; ++i) {
      const double R = ring.inner + (ring.outer - ring.inner) * (i + 0.5) / radii;
      const RingParameter xi = ring_parameter(motion, R);
      const RingKinematics kinematics = ring_kinematics(motion, R, t);
      Tensor tau, dtau;
      isochrone.at(xi.value, tau, dtau);
      const Polar b = kinematics.body_force(density, R, tau, xi.slope * dtau);
      largest_force = std::max(largest_force, std::hypot(b.r, b.theta));
      const double divergence =
          std::abs(xi.slope) * dtau_error + (std::abs(kinematics.alpha_slope) + 2 / R) * tau_error;  // (26), (27)
      largest_error = std::max(largest_error, std::numbers::sqrt2 * divergence / density);           // both components
    }
  }
  return largest_force > 0 ? largest_error / largest_force : 0;
}

}  // namespace assay
