// SPDX-License-Identifier: BSD-3-Clause
// General polar motion x = rho(R, t) e_r(Theta + alpha(R, t)): what the vortex, the expanding and the twisting ring
// have in common. With r = (e_r, e_theta, e_z) at the current angle and q at Theta, F = r B q^T and T = r tau q^T (20),
// where the baseline B and tau depend on R and t alone.
#pragma once

#include "harness/motion/amplitude.hpp"
#include "harness/motion/exact_state.hpp"

namespace assay {

/// Between two radii around the origin [m].
struct Annulus {
  double inner = 0, outer = 0;
  bool holds(double R) const { return R > inner && R < outer; }  ///< R: [m]
};

/// Components of a vector along e_r, e_theta at the current angle Theta + alpha (25).
struct Polar {
  double r = 0, theta = 0;
};

/// Of the turn alpha = g(t) h(R), everything that depends on R alone.
struct RingProfile {
  double h = 0;         ///< [1]
  double h_prime = 0;   ///< h' [1/m]
  double xi = 0;        ///< xi = R h' / 2 (13) [1]
  double xi_prime = 0;  ///< d xi / d R = (h' + R h'') / 2 [1/m]
};

/// Of the change of the radii rho - R = w(t) U(R): U and U' [1], [1/m].
struct RingRadial {
  double U = 0, slope = 0;
};

/// rho [m] and alpha [rad] at one R and t; slope: d / d R, rate: d / d t.
struct RingKinematics {
  double rho = 0, rho_slope = 1, rho_rate = 0, rho_slope_rate = 0, rho_acceleration = 0;
  double rho_slope_acceleration = 0;
  double alpha = 0, alpha_slope = 0, alpha_rate = 0, alpha_slope_rate = 0, alpha_acceleration = 0;
  double alpha_slope_acceleration = 0;

  /// rho = R, alpha = g h.
  static RingKinematics turned(double R, const RingProfile& profile, const AmplitudeValue& g);

  /// Adds w U to rho. w: with its rates [m], [m/s], [m/s^2].
  void widen(const RingRadial& u, const AmplitudeValue& w);

  /// B = [[rho', 0], [rho alpha', rho/R]], 1 in E3 E3 [1].
  Tensor baseline(double R) const;
  /// Its rate at fixed R > 0 [1/s].
  Tensor baseline_rate(double R) const;

  /// a_r = rho.. - rho alpha.^2, a_theta = rho alpha.. + 2 rho. alpha. [m/s^2].
  Polar acceleration() const;
  /// d / d R of both [1/s^2].
  Polar acceleration_slope() const;

  /// Of the reference point X, whose distance from the axis is R.
  ExactState state(const Vector3& X) const;

  /// DIV(T): d tau11/dR - alpha' tau21 + (tau11 - tau22)/R, d tau21/dR + alpha' tau11 + (tau12 + tau21)/R at fixed t,
  /// of which (26), (27) are the vortex's [N/m^3].
  Polar divergence(double R, const Tensor& tau, const Tensor& dtau_dR) const;

  /// b = a - DIV(T)/rho0 [m/s^2].
  Polar body_force(double density, double R, const Tensor& tau, const Tensor& dtau_dR) const;

  /// T = r tau q^T [Pa] at the reference point X.
  Tensor first_piola_kirchhoff(const Vector3& X, const Tensor& tau) const;

  /// r v of the components of a vector at the reference point X.
  Vector3 cartesian(const Vector3& X, const Polar& v) const;
};

}  // namespace assay
