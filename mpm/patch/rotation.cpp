// SPDX-License-Identifier: BSD-3-Clause
// The square that turns, and what is measured of any body that does.
#include "mpm/patch/rotation.hpp"

#include <cmath>

#include "harness/numeric/norms.hpp"
#include "mpm/kernels/affine.hpp"

namespace assay::mpm {

namespace {

constexpr Axis out_of_plane{0, 0, 1};

/// b of the exact motion at the beginning of the step [m/s^2].
template <int Dim>
Pass<Dim> centripetal_force(const Axis& axis) {
  Pass<Dim> pass;
  pass.name = "body_force";
  pass.doc = "the body force of a rigid rotation";
  pass.called_for_by = "patch test";
  pass.reads = {Column::reference_position};
  pass.writes = {Column::body_force};
  pass.bind = [axis](State<Dim>& s) -> Kernel {
    return [&s, axis](const Instant& now) {
      const Mat<Dim> Q = turned_by<Dim>(axis, now.t);
      for (std::size_t p = 0; p < s.particles; ++p) {
        Vec<Dim> x = image_of<Dim>(Q, s.template at<Dim>(Column::reference_position, p));
        if constexpr (Dim == 3) {  // from the axis
          const double along = axis[0] * x[0] + axis[1] * x[1] + axis[2] * x[2];
          for (std::size_t d = 0; d < 3; ++d) x[d] -= along * axis[d];
        }
        for (std::size_t d = 0; d < Dim; ++d) s.column(Column::body_force, d)[p] = -turning_rate * turning_rate * x[d];
      }
    };
  };
  return pass;
}

}  // namespace

template <int Dim>
Mat<Dim> turned_by(const Axis& n, double t) {
  const double c = std::cos(turning_rate * t), sine = std::sin(turning_rate * t);
  if constexpr (Dim == 2) return {c, -sine, sine, c};
  Mat<Dim> Q = cross_of<Dim>(n);
  for (std::size_t k = 0; k < Q.size(); ++k)
    Q[k] = sine * Q[k] + (1 - c) * n[k / Dim] * n[k % Dim] + (k % (Dim + 1) == 0 ? c : 0);
  return Q;
}

template <int Dim>
Turned<Dim> turn_body(Setup<Dim> setup, const Bench<Dim>& bench, const Axis& axis, double angle, double step) {
  const Method method = setup.method;
  auto passes = bench.passes(setup);
  if (setup.body_force) replace(passes, Phase::body_force, centripetal_force<Dim>(axis));
  Turned<Dim> turned{std::make_unique<Simulation<Dim>>(std::move(setup), passes)};
  State<Dim>& s = turned.simulation->state();
  Mat<Dim> spin = cross_of<Dim>(axis);
  for (double& component : spin) component *= turning_rate;
  for (std::size_t p = 0; p < s.particles; ++p) {
    const Vec<Dim> v = image_of<Dim>(spin, s.template at<Dim>(Column::reference_position, p));
    for (std::size_t d = 0; d < Dim; ++d) s.column(Column::velocity, d)[p] = v[d];
    for (std::size_t c = 0; method.is_affine() && c < spin.size(); ++c) s.column(affine_column(method), c)[p] = spin[c];
  }
  const double end = angle / turning_rate;
  const int steps = static_cast<int>(std::ceil(end / step));
  const double dt = end / steps;
  for (int k = 0; k < steps; ++k) {
    turned.t = k * dt;
    if (const auto& finding = turned.simulation->step(k * dt, dt)) {
      turned.finding = finding;
      return turned;
    }
  }
  turned.t = end;
  return turned;
}

namespace {

/// L2 over the body.
struct Errors {
  double displacement = INFINITY, deformation = INFINITY, volume = INFINITY;
  std::optional<Finding> finding;
  double t = 0;
};

/// On grids each of which has half the h and dt of the one before, and on the last but one with half its dt alone.
struct Series {
  std::vector<Errors> runs;
  Errors shorter;
};

template <int Dim>
Errors errors_of(const Turned<Dim>& turned) {
  if (turned.finding) return {INFINITY, INFINITY, INFINITY, turned.finding, turned.t};
  const State<Dim>& s = turned.state();
  NormAccumulator displacement, deformation, volume;
  const Mat<Dim> Q = turned_by<Dim>(out_of_plane, turned.t);
  for (std::size_t p = 0; p < s.particles; ++p) {
    const double V = s.column(Column::volume)[p];
    const Vec<Dim> x = image_of<Dim>(Q, s.template at<Dim>(Column::reference_position, p));
    double square = 0;
    for (std::size_t d = 0; d < Dim; ++d) {
      const double u = s.column(Column::position, d)[p] - x[d];
      square += u * u;
    }
    displacement.add(V, square);
    const Mat<Dim> F = s.template at<Dim * Dim>(Column::deformation_gradient, p);
    square = 0;
    for (std::size_t k = 0; k < F.size(); ++k) square += (F[k] - Q[k]) * (F[k] - Q[k]);
    deformation.add(V, square);
    volume.add(V, std::pow(determinant<Dim>(F) - 1, 2));
  }
  return {displacement.l2(), deformation.l2(), volume.l2(), {}, turned.t};
}

/// The error must fall at least so when h and dt are halved: 0.8 is the least found where this is promised, and a
/// defect leaves an error that does not fall.
constexpr double least_order = 0.5;

/// Of the plane.
[[maybe_unused]] check::TestResult judged_series(const Method& method, const std::string& id, const Series& series,
                                                 double Errors::*kind, const std::string& what) {
  const auto& runs = series.runs;
  const Errors &before_last = runs[runs.size() - 2], &finest = runs.back();
  const double before = before_last.*kind, last = finest.*kind;
  const auto told = [&](const Errors& run) { return run.finding ? std::string("unstable") : digits(run.*kind); };
  Figure figure{last, {}};
  if (finest.finding) {
    figure.sentence = "unstable at t = " + digits(finest.t) + " s: " + finest.finding->reason;
  } else {
    figure.sentence = "L2 of " + what + " after 1.41 rad: ";
    for (const Errors& run : runs) figure.sentence += told(run) + ", ";
    figure.sentence += "h and dt halved each time; the second with dt alone halved: " + told(series.shorter);
    if (std::isfinite(before)) figure.order = observed_order(2, before, 1, last);
  }
  const double most = std::isfinite(before) ? before * std::pow(2, -least_order) : 0;
  return judged(method, id, figure, most, "error of a rigid rotation does not fall");
}

}  // namespace

template <int Dim>
std::vector<check::TestResult> rotation(const Method& method, const Bench<Dim>& bench) {
  if constexpr (Dim == 3) {
    auto results = turning_slabs(method, bench);
    for (check::TestResult& result : turning_cube(method, bench)) results.push_back(std::move(result));
    return results;
  } else {
    // a spline as wide as the body tells nothing
    const int coarsest = bench.quick && !traits_of<Dim>(method.basis).is_spline() ? 4 : 8;
    const auto turned = [&](int across, double share) {
      const double step = share * time_step(bench, across, square_speed);
      return errors_of(turn_body(forced(patch_setup(method, bench, across)), bench, out_of_plane, square_turn, step));
    };
    Series series;
    for (int k = 0; k < 3; ++k) series.runs.push_back(turned(coarsest << k, 1));
    series.shorter = turned(2 * coarsest, 0.5);
    return {judged_series(method, "rotation.displacement", series, &Errors::displacement, "the displacement [m]"),
            judged_series(method, "rotation.deformation", series, &Errors::deformation, "F - Q"),
            judged_series(method, "rotation.volume", series, &Errors::volume, "J - 1")};
  }
}

template Mat<ASSAY_DIMENSION> turned_by<ASSAY_DIMENSION>(const Axis&, double);
template Turned<ASSAY_DIMENSION> turn_body(Setup<ASSAY_DIMENSION>, const Bench<ASSAY_DIMENSION>&, const Axis&, double,
                                           double);
template std::vector<check::TestResult> rotation(const Method&, const Bench<ASSAY_DIMENSION>&);

}  // namespace assay::mpm
