// SPDX-License-Identifier: BSD-3-Clause
// x = Q(omega t) X under b = -omega^2 x: the exact motion needs no stress, so that all error is the method's.
#include <cmath>

#include "harness/numeric/norms.hpp"
#include "mpm/kernels/affine.hpp"
#include "mpm/patch/patch.hpp"

namespace assay::mpm {

namespace {

/// As fast as the material still holds: rho omega^2 L^2 = 9 E, so that a wrong body force shows in all errors. At omega
/// = 1 the stress makes up for half of b; from omega = 10 on it no longer holds J on the grids used here.
constexpr double omega = 3;                   ///< [1/s]
constexpr double angle = 1.4142135623730951;  ///< sqrt 2 [rad]
constexpr double edge_speed = 0.71 * omega;   ///< of the body's corners [m/s]
/// The error must fall at least so when h and dt are halved: 0.8 is the least found where this is promised, and a
/// defect leaves an error that does not fall.
constexpr double least_order = 0.5;

/// b of the exact motion at the beginning of the step [m/s^2].
Pass<2> centripetal_force() {
  Pass<2> pass;
  pass.name = "body_force";
  pass.doc = "the body force of a rigid rotation";
  pass.called_for_by = "patch test";
  pass.reads = {Column::reference_position};
  pass.writes = {Column::body_force};
  pass.bind = [](State<2>& s) -> Kernel {
    return [&s](const Instant& now) {
      const double c = std::cos(omega * now.t), sine = std::sin(omega * now.t);
      for (std::size_t p = 0; p < s.particles; ++p) {
        const double X = s.column(Column::reference_position, 0)[p], Y = s.column(Column::reference_position, 1)[p];
        s.column(Column::body_force, 0)[p] = -omega * omega * (c * X - sine * Y);
        s.column(Column::body_force, 1)[p] = -omega * omega * (sine * X + c * Y);
      }
    };
  };
  return pass;
}

/// L2 over the body at the end.
struct Errors {
  double displacement = INFINITY, deformation = INFINITY, volume = INFINITY;
  std::optional<Finding> finding;
  double t = 0;
};

Errors measure(const State<2>& s, double t) {
  NormAccumulator displacement, deformation, volume;
  const double c = std::cos(omega * t), sine = std::sin(omega * t);
  const std::array<double, 4> Q{c, -sine, sine, c};
  for (std::size_t p = 0; p < s.particles; ++p) {
    const double V = s.column(Column::volume)[p];
    const double X = s.column(Column::reference_position, 0)[p], Y = s.column(Column::reference_position, 1)[p];
    const double u = s.column(Column::position, 0)[p] - (c * X - sine * Y);
    const double v = s.column(Column::position, 1)[p] - (sine * X + c * Y);
    displacement.add(V, u * u + v * v);
    const Mat<2> F = s.at<4>(Column::deformation_gradient, p);
    double square = 0;
    for (std::size_t k = 0; k < 4; ++k) square += (F[k] - Q[k]) * (F[k] - Q[k]);
    deformation.add(V, square);
    volume.add(V, std::pow(determinant<2>(F) - 1, 2));
  }
  return {displacement.l2(), deformation.l2(), volume.l2(), {}, t};
}

/// `share`: of the longest step.
Errors rotate(const Method& method, const Bench& bench, int across, double share = 1) {
  Setup<2> setup = patch_setup(method, bench, across);
  setup.body_force = true;
  auto passes = bench.passes(setup);
  replace(passes, Phase::body_force, centripetal_force());
  Simulation<2> simulation(setup, passes);
  State<2>& s = simulation.state();
  for (std::size_t p = 0; p < s.particles; ++p) {  // omega E_z x X
    s.column(Column::velocity, 0)[p] = -omega * s.column(Column::reference_position, 1)[p];
    s.column(Column::velocity, 1)[p] = omega * s.column(Column::reference_position, 0)[p];
    if (!method.is_affine()) continue;
    s.column(affine_column(method), 1)[p] = -omega;
    s.column(affine_column(method), 2)[p] = omega;
  }
  const double end = angle / omega;
  const int steps = static_cast<int>(std::ceil(end / (share * time_step(bench, across, edge_speed))));
  const double dt = end / steps;
  for (int k = 0; k < steps; ++k) {
    if (const auto& finding = simulation.step(k * dt, dt)) return {INFINITY, INFINITY, INFINITY, finding, k * dt};
  }
  return measure(s, end);
}

/// Grids of h, h/2, h/4, and the middle one with half its step.
struct Series {
  std::array<Errors, 3> runs;
  Errors shorter;
};

/// One kind of error: what is left on the finest grid, the order of the last halving, and whether it falls.
check::TestResult judged_series(const Method& method, const std::string& id, const Series& series, double Errors::*kind,
                                const std::string& what) {
  const auto& runs = series.runs;
  const double before = runs[1].*kind, last = runs[2].*kind;
  const auto told = [&](const Errors& run) { return run.finding ? std::string("unstable") : digits(run.*kind); };
  Figure figure{last, {}};
  if (runs[2].finding) {
    figure.sentence = "unstable at t = " + digits(runs[2].t) + " s: " + runs[2].finding->reason;
  } else {
    figure.sentence = "L2 of " + what + " after 1.41 rad: " + told(runs[0]) + ", " + told(runs[1]) + ", " +
                      told(runs[2]) +
                      ", h and dt halved each time; the second with dt alone halved: " + told(series.shorter);
    if (std::isfinite(before)) figure.order = observed_order(2, before, 1, last);
  }
  const double most = std::isfinite(before) ? before * std::pow(2, -least_order) : 0;
  return judged(method, id, figure, most, "error of a rigid rotation does not fall");
}

}  // namespace

std::vector<check::TestResult> rotation(const Method& method, const Bench& bench) {
  // a spline as wide as the body tells nothing
  const int across = bench.quick && !traits_of<2>(method.basis).is_spline() ? 4 : 8;
  Series series;
  for (std::size_t k = 0; k < 3; ++k) series.runs[k] = rotate(method, bench, across << k);
  series.shorter = rotate(method, bench, 2 * across, 0.5);
  return {judged_series(method, "rotation.displacement", series, &Errors::displacement, "the displacement [m]"),
          judged_series(method, "rotation.deformation", series, &Errors::deformation, "F - Q"),
          judged_series(method, "rotation.volume", series, &Errors::volume, "J - 1")};
}

}  // namespace assay::mpm
