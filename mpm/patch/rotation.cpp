// SPDX-License-Identifier: BSD-3-Clause
// x = Q(omega t) X under b = -omega^2 x: the exact motion needs no stress, so that all error is the method's.
#include <algorithm>
#include <cmath>

#include "harness/numeric/norms.hpp"
#include "mpm/kernels/affine.hpp"
#include "mpm/patch/patch.hpp"

namespace assay::mpm {

namespace {

/// As fast as the material still holds: rho omega^2 L^2 = 9 E, so that a wrong body force shows in all errors. At omega
/// = 1 the stress makes up for half of b; from omega = 10 on it no longer holds J on the grids used here.
constexpr double omega = 3;  ///< [1/s]
template <int Dim>
constexpr double angle = 1.4142135623730951 / (Dim == 2 ? 1 : 4);  ///< sqrt 2, in space a quarter of it [rad]
template <int Dim>
constexpr double edge_speed = (Dim == 2 ? 0.71 : 0.87) * omega;  ///< of the body's corners at most [m/s]
/// The error must fall with h and dt with this order at least: 0.8 is the least found where this is promised, and a
/// defect leaves an error that does not fall.
constexpr double least_order = 0.5;

/// n: unit vector along (1, 2, 3).
constexpr std::array<double, 3> rotation_axis{0.26726124191242440, 0.53452248382484880, 0.80178372573727314};

/// n x, so that the velocity is omega n x x; in the plane about E_z.
template <int Dim>
Mat<Dim> cross_axis() {
  if constexpr (Dim == 2) return {0, -1, 1, 0};
  if constexpr (Dim == 3)
    return {0, -rotation_axis[2], rotation_axis[1],  rotation_axis[2],
            0, -rotation_axis[0], -rotation_axis[1], rotation_axis[0],
            0};
}

/// Q after t.
template <int Dim>
Mat<Dim> turned_by(double t) {
  const double c = std::cos(omega * t), sine = std::sin(omega * t);
  if constexpr (Dim == 2) return {c, -sine, sine, c};
  Mat<Dim> Q = cross_axis<Dim>();
  for (std::size_t k = 0; k < Q.size(); ++k)
    Q[k] = sine * Q[k] + (1 - c) * rotation_axis[k / Dim] * rotation_axis[k % Dim] + (k % (Dim + 1) == 0 ? c : 0);
  return Q;
}

/// b of the exact motion at the beginning of the step [m/s^2].
template <int Dim>
Pass<Dim> centripetal_force() {
  Pass<Dim> pass;
  pass.name = "body_force";
  pass.doc = "the body force of a rigid rotation";
  pass.called_for_by = "patch test";
  pass.reads = {Column::reference_position};
  pass.writes = {Column::body_force};
  pass.bind = [](State<Dim>& s) -> Kernel {
    return [&s](const Instant& now) {
      const Mat<Dim> Q = turned_by<Dim>(now.t);
      for (std::size_t p = 0; p < s.particles; ++p) {
        Vec<Dim> x = image_of<Dim>(Q, s.template at<Dim>(Column::reference_position, p));
        if constexpr (Dim == 3) {  // from the axis
          const double along = rotation_axis[0] * x[0] + rotation_axis[1] * x[1] + rotation_axis[2] * x[2];
          for (std::size_t d = 0; d < 3; ++d) x[d] -= along * rotation_axis[d];
        }
        for (std::size_t d = 0; d < Dim; ++d) s.column(Column::body_force, d)[p] = -omega * omega * x[d];
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

/// Cells across the body, and the particles that are measured: those whose coordinates are at most `inner` [m].
struct Grids {
  std::vector<int> across;
  double inner = INFINITY;
};

/// A spline as wide as the body tells nothing. In space bodies are so small that errors of the free faces hide all
/// others, and only particles are measured that these have hardly reached.
template <int Dim>
Grids grids_of(const Method& method, const Bench<Dim>& bench) {
  const BasisTraits basis = traits_of<Dim>(method.basis);
  if (Dim == 3) return basis.is_spline() && basis.nodes_across > 3 ? Grids{{8, 12}, 0.17} : Grids{{6, 8}, 0.25};
  const int across = bench.quick && !basis.is_spline() ? 4 : 8;
  return {{across, 2 * across, 4 * across}};
}

template <int Dim>
Errors measure(const State<Dim>& s, double t, double inner) {
  NormAccumulator displacement, deformation, volume;
  const Mat<Dim> Q = turned_by<Dim>(t);
  for (std::size_t p = 0; p < s.particles; ++p) {
    const double V = s.column(Column::volume)[p];
    const Vec<Dim> X = s.template at<Dim>(Column::reference_position, p), x = image_of<Dim>(Q, X);
    if (std::any_of(X.begin(), X.end(), [&](double along) { return std::abs(along) > inner; })) continue;
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
  return {displacement.l2(), deformation.l2(), volume.l2(), {}, t};
}

/// `share`: of the longest step.
template <int Dim>
Errors rotate(const Method& method, const Bench<Dim>& bench, int across, double inner, double share = 1) {
  Setup<Dim> setup = patch_setup(method, bench, across);
  setup.body_force = true;
  auto passes = bench.passes(setup);
  replace(passes, Phase::body_force, centripetal_force<Dim>());
  Simulation<Dim> simulation(setup, passes);
  State<Dim>& s = simulation.state();
  Mat<Dim> spin = cross_axis<Dim>();
  for (double& component : spin) component *= omega;
  for (std::size_t p = 0; p < s.particles; ++p) {
    const Vec<Dim> v = image_of<Dim>(spin, s.template at<Dim>(Column::reference_position, p));
    for (std::size_t d = 0; d < Dim; ++d) s.column(Column::velocity, d)[p] = v[d];
    for (std::size_t c = 0; method.is_affine() && c < spin.size(); ++c) s.column(affine_column(method), c)[p] = spin[c];
  }
  const double end = angle<Dim> / omega;
  const int steps = static_cast<int>(std::ceil(end / (share * time_step(bench, across, edge_speed<Dim>))));
  const double dt = end / steps;
  for (int k = 0; k < steps; ++k) {
    if (const auto& finding = simulation.step(k * dt, dt)) return {INFINITY, INFINITY, INFINITY, finding, k * dt};
  }
  return measure(s, end, inner);
}

/// The same rotation on finer and finer grids, and on the last but one with half its step.
struct Series {
  std::vector<int> across;  ///< cells
  std::vector<Errors> runs;
  Errors shorter;
  std::string after = " after 1.41 rad: ";
  std::string how =
      ", h and dt halved each time; the second with dt alone halved: ";  ///< they were found, as a sentence has it
                                                                         ///< between them and the shorter one
};

/// One kind of error: what is left on the finest grid, the order of the last halving, and whether it falls.
check::TestResult judged_series(const Method& method, const std::string& id, const Series& series, double Errors::*kind,
                                const std::string& what) {
  const auto& runs = series.runs;
  const Errors &before_last = runs[runs.size() - 2], &finest = runs.back();
  const double before = before_last.*kind, last = finest.*kind;
  const double ratio = static_cast<double>(series.across.back()) / series.across[runs.size() - 2];
  const auto told = [&](const Errors& run) { return run.finding ? std::string("unstable") : digits(run.*kind); };
  Figure figure{last, {}};
  if (finest.finding) {
    figure.sentence = "unstable at t = " + digits(finest.t) + " s: " + finest.finding->reason;
  } else {
    std::string errors;
    for (const Errors& run : runs) errors += (errors.empty() ? "" : ", ") + told(run);
    figure.sentence = "L2 of " + what + series.after + errors + series.how + told(series.shorter);
    if (std::isfinite(before)) figure.order = observed_order(ratio, before, 1, last);
  }
  const double most = std::isfinite(before) ? before * std::pow(ratio, -least_order) : 0;
  return judged(method, id, figure, most, "error of a rigid rotation does not fall");
}

}  // namespace

template <int Dim>
std::vector<check::TestResult> rotation(const Method& method, const Bench<Dim>& bench) {
  const Grids grids = grids_of(method, bench);
  Series series{grids.across, {}, {}};
  if (Dim == 3) {
    series.after = " of the inner part after 0.35 rad: ";
    series.how = " on " + std::to_string(grids.across[0]) + " and " + std::to_string(grids.across[1]) +
                 " cells, dt by h; the first with dt alone halved: ";
  }
  for (const int across : grids.across) series.runs.push_back(rotate(method, bench, across, grids.inner));
  series.shorter = rotate(method, bench, grids.across[grids.across.size() - 2], grids.inner, 0.5);
  return {judged_series(method, "rotation.displacement", series, &Errors::displacement, "the displacement [m]"),
          judged_series(method, "rotation.deformation", series, &Errors::deformation, "F - Q"),
          judged_series(method, "rotation.volume", series, &Errors::volume, "J - 1")};
}

template std::vector<check::TestResult> rotation(const Method&, const Bench<ASSAY_DIMENSION>&);

}  // namespace assay::mpm
