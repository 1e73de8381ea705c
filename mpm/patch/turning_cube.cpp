// SPDX-License-Identifier: BSD-3-Clause
// A cube that turns about (1, 2, 3): in the same way whatever the order of the axes, with the momentum that it is
// given, and in one step with no more strain and stress than the step's own.

#if ASSAY_DIMENSION == 3
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "harness/numeric/norms.hpp"
#include "mpm/kernels/affine.hpp"
#include "mpm/patch/rotation.hpp"

namespace assay::mpm {

namespace {

constexpr Axis tilted_axis{0.26726124191242440, 0.53452248382484880, 0.80178372573727314};  ///< along (1, 2, 3)
constexpr double cube_turn = 0.5 * square_turn;                                             ///< [rad]
constexpr double cube_speed = 0.87 * turning_rate;  ///< of its corners at most [m/s]
constexpr double kept_momentum = 1e-12;             ///< rounding: at most 1e-14 is found

/// Largest |F - Q| of one step over its angle squared, and largest stress over rho c^2 times that. From F = I + dt W,
/// as where stress comes first, or I + dt W + dt^2 W^2, and W = omega n x: sqrt(1/2), and (lambda + mu) / rho c^2 times
/// a component of I - n (x) n, 0.69 for the material of the bench. Up to 0.71 is found: a little of the faces comes to
/// it, with a consistent mass through the whole body.
constexpr double most_of_a_step = 0.8;

/// The angle of that step [rad], and how many cells are between the particles that are measured and the faces.
struct SmallStep {
  double angle;
  int inside;
};
SmallStep small_step(const Method& method) {
  if (method.mass == Mass::consistent) return {0.04, 6};
  const BasisTraits basis = traits_of<3>(method.basis);
  return {0.01, basis.is_spline() ? std::max(4, basis.nodes_across) : 3};
}

/// The axes of another cube on which those of the first are, and 1, or -1 where that is a mirror image.
struct Relabelled {
  std::array<std::size_t, 3> axes;
  double handedness;
};
constexpr Relabelled cyclic{{1, 2, 0}, 1}, mirrored{{1, 0, 2}, -1};

/// About which the other cube turns: a mirror reverses the sense of a rotation.
Axis relabelled_axis(const Relabelled& to) {
  Axis n;
  for (std::size_t d = 0; d < 3; ++d) n[to.axes[d]] = to.handedness * tilted_axis[d];
  return n;
}

Turned<3> turn_cube(const Setup<3>& setup, const Bench<3>& bench, const Axis& axis) {
  return turn_body(setup, bench, axis, cube_turn, time_step(bench, cells_across(bench), cube_speed));
}

check::TestResult same_along_all_axes(const Method& method, const Bench<3>& bench, const Turned<3>& cube) {
  Figure figure{0, {}};
  for (const Relabelled& to : {cyclic, mirrored}) {
    const Turned<3> other = turn_cube(cube.state().setup, bench, relabelled_axis(to));
    const bool is_good = !cube.finding && !other.finding;
    const double distance = 0.5 * cube.state().setup.grid.spacing;
    figure.measure =
        larger(figure.measure, is_good ? difference(cube.state(), other.state(), to.axes, distance) : double{INFINITY});
  }
  figure.sentence = std::isfinite(figure.measure)
                        ? "about (1, 2, 3), (3, 1, 2) and -(2, 1, 3) cubes turn in the same way but for " +
                              digits(figure.measure) + " m in places, or in F"
                        : "unstable before it has turned by 0.71 rad";
  return judged(method, "tilted.axes", figure, same_motion, "the motion depends on which axis is which");
}

/// It begins with none, and the body force gives none: it is symmetric about the origin.
check::TestResult linear_momentum(const Method& method, const Turned<3>& cube) {
  Figure figure{INFINITY, "unstable at t = " + digits(cube.t) + " s"};
  if (!cube.finding) {
    const Momentum<3> found = momentum_of(cube.state());
    figure.measure = 0;
    for (const double component : found.linear)
      figure.measure = larger(figure.measure, std::abs(component) / found.scale);
    figure.sentence = "after 0.71 rad the momentum is " + digits(figure.measure) + " of the sum of m |v|";
  }
  return judged(method, "tilted.momentum", figure, kept_momentum, "momentum not conserved");
}

/// Largest change of the particles' angular momentum about an axis, over the sum of m |x| |v|.
double change_of_angular_momentum(const State<3>& s) {
  Momentum<3> found = momentum_of(s);
  Mat<3> spin = cross_of<3>(tilted_axis);
  for (double& component : spin) component *= -turning_rate;
  for (std::size_t p = 0; p < s.particles; ++p) {
    const Vec<3> X = s.at<3>(Column::reference_position, p);
    add_moment(found.angular, s.column(Column::mass)[p], X, image_of<3>(spin, X));
  }
  const auto [least, most] = std::minmax_element(found.angular.begin(), found.angular.end());
  return std::max(-*least, *most) / found.angular_scale;
}

/// About all three axes, of a cube without body force: on the grid where the accounts have it.
check::TestResult angular_momentum(const Method& method, const Bench<3>& bench) {
  Setup<3> setup = patch_setup(method, bench, cells_across(bench));
  setup.accounts = true;
  const Turned<3> cube = turn_cube(setup, bench, tilted_axis);
  const Ledger& ledger = cube.state().ledger;
  Figure figure{INFINITY, "unstable at t = " + digits(cube.t) + " s"};
  if (!cube.finding) {
    const bool is_known = ledger.grid_angular.has_value();
    figure.measure =
        is_known ? ledger.grid_angular_defect / ledger.grid_angular_scale : change_of_angular_momentum(cube.state());
    figure.sentence = "without body force the angular momentum changes by up to " + digits(figure.measure) +
                      " of the sum of m |x| |v|";
  }
  return judged(method, "tilted.angular", figure, kept_momentum, "angular momentum not conserved");
}

/// Of the particles that no face has reached.
struct StepErrors {
  double strain = INFINITY, stress = INFINITY;  ///< over the angle squared; the stress over rho c^2 too
};

StepErrors errors_of_a_step(const Method& method, const Bench<3>& bench, const SmallStep& small) {
  const auto& [angle, inside] = small;
  const int across = 2 * inside + 2;
  const Setup<3> setup = forced(patch_setup(method, bench, across));
  const Turned<3> cube = turn_body(setup, bench, tilted_axis, angle, angle / turning_rate);
  if (cube.finding) return {};
  const State<3>& s = cube.state();
  const Mat<3> Q = turned_by<3>(tilted_axis, cube.t);
  StepErrors found{-1, -1};
  for (std::size_t p = 0; p < s.particles; ++p) {
    const Vec<3> X = s.at<3>(Column::reference_position, p);
    if (std::any_of(X.begin(), X.end(), [&](double x) { return std::abs(x) > setup.grid.spacing; })) continue;
    const Mat<3> F = s.at<9>(Column::deformation_gradient, p);
    double square = 0;
    for (std::size_t c = 0; c < F.size(); ++c) square += (F[c] - Q[c]) * (F[c] - Q[c]);
    found.strain = larger(found.strain, std::sqrt(square) / (angle * angle));
    const double scale = bench.density * bench.wave_speed * bench.wave_speed * angle * angle;
    for (std::size_t c = 0; c < stress_components<3>; ++c)
      found.stress = larger(found.stress, std::abs(s.column(Column::stress, c)[p]) / scale);
  }
  if (found.strain < 0) throw std::logic_error("no particle sees nothing but the inside");
  return found;
}

check::TestResult of_a_step(const Method& method, const std::string& id, double whole, double half, double angle,
                            const std::string& what) {
  Figure figure{whole, "one step by " + digits(angle) + " rad: inside the cube " + what + " is " + digits(whole) +
                           " of the angle squared, for half the angle " + digits(half)};
  if (std::isfinite(whole)) figure.order = observed_order(2, whole, 1, 0.25 * half);
  return judged(method, id, figure, most_of_a_step, "a step of a rigid rotation strains the body");
}

}  // namespace

std::vector<check::TestResult> turning_cube(const Method& method, const Bench<3>& bench) {
  const Turned<3> cube = turn_cube(forced(patch_setup(method, bench, cells_across(bench))), bench, tilted_axis);
  const auto& [angle, inside] = small_step(method);
  const StepErrors whole = errors_of_a_step(method, bench, {angle, inside}),
                   half = errors_of_a_step(method, bench, {0.5 * angle, inside});
  return {same_along_all_axes(method, bench, cube), linear_momentum(method, cube), angular_momentum(method, bench),
          of_a_step(method, "tilted.strain", whole.strain, half.strain, angle, "F - Q"),
          of_a_step(method, "tilted.stress", whole.stress, half.stress, angle, "the stress over rho c^2")};
}

}  // namespace assay::mpm
#endif
