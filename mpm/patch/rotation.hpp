// SPDX-License-Identifier: BSD-3-Clause
// A body that turns rigidly, x = Q(omega t) X, under the body force that this needs: what the tests of rotation share.
// The exact motion needs no stress, so that all error is the method's.
#pragma once

#include <memory>

#include "mpm/patch/patch.hpp"

namespace assay::mpm {

/// As fast as the material still holds: rho omega^2 L^2 = 9 E, so that a wrong body force shows in all errors. At omega
/// = 1 the stress makes up for half of b; from omega = 10 on it no longer holds J on the grids used here.
inline constexpr double turning_rate = 3;                    ///< omega [1/s]
inline constexpr double square_turn = 1.4142135623730951;    ///< sqrt 2, by which the square turns [rad]
inline constexpr double square_speed = 0.71 * turning_rate;  ///< of its corners [m/s]

/// n: a unit vector; velocities are omega n x x.
using Axis = std::array<double, 3>;

/// The matrix of n x.
template <int Dim>
Mat<Dim> cross_of(const Axis& n) {
  if constexpr (Dim == 2) return {0, -n[2], n[2], 0};
  if constexpr (Dim == 3) return {0, -n[2], n[1], n[2], 0, -n[0], -n[1], n[0], 0};
}

/// Q after t.
template <int Dim>
Mat<Dim> turned_by(const Axis& n, double t);

/// A body that has turned, or one whose run has ended before.
template <int Dim>
struct Turned {
  std::unique_ptr<Simulation<Dim>> simulation;
  std::optional<Finding> finding = {};
  double t = 0;  ///< of the end, or of the step that failed [s]
  const State<Dim>& state() const { return simulation->state(); }
};

/// The setup with the body force that keeps a rotation rigid.
template <int Dim>
Setup<Dim> forced(Setup<Dim> setup) {
  setup.body_force = true;
  return setup;
}

/// Without stress and with the velocities of the motion at first, by `angle` in equal steps of at most `step` [rad],
/// [s]. Without the body force the body stretches as it turns.
template <int Dim>
Turned<Dim> turn_body(Setup<Dim> setup, const Bench<Dim>& bench, const Axis& axis, double angle, double step);

// In space.

/// Largest difference of position [m] and of F between a body and one in space, whose axes[d] is axis d of the first.
/// Their particles are the same lattice, `distance` apart at least [m]. In the plane nothing moves along the third.
template <int Dim>
double difference(const State<Dim>& one, const State<3>& other, const std::array<std::size_t, 3>& axes,
                  double distance);

/// Two runs of the same motion differ by rounding, which grows on the way: at most 3e-13 is found.
inline constexpr double same_motion = 1e-11;

/// The square as a slab that repeats across x, y or z.
std::vector<check::TestResult> turning_slabs(const Method& method, const Bench<3>& bench);

/// A cube about (1, 2, 3).
std::vector<check::TestResult> turning_cube(const Method& method, const Bench<3>& bench);

}  // namespace assay::mpm
