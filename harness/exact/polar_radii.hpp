// SPDX-License-Identifier: BSD-3-Clause
// Columns of what the points of a polar motion have in common with others at their radius.
#pragma once

#include <vector>

#include "harness/motion/motion.hpp"

namespace assay {

/// What an array of radii has each of.
struct RadiusColumns {
  std::vector<double> R, h, h_prime, xi, xi_slope;
  std::vector<RingRadial> radial;  ///< empty where no radius changes

  void add(const Motion& motion, double radius) {
    const PolarMotion& polar = *motion->polar();
    const RingProfile profile = polar.profile(radius);
    const RingParameter parameter = ring_parameter(motion, radius);
    R.push_back(radius), h.push_back(profile.h), h_prime.push_back(profile.h_prime);
    xi.push_back(parameter.value), xi_slope.push_back(parameter.slope);
    if (polar.widens()) radial.push_back(polar.radial(radius));
  }
  void add(const RadiusColumns& from, std::size_t k) {
    R.push_back(from.R[k]), h.push_back(from.h[k]), h_prime.push_back(from.h_prime[k]);
    xi.push_back(from.xi[k]), xi_slope.push_back(from.xi_slope[k]);
    if (!from.radial.empty()) radial.push_back(from.radial[k]);
  }
  void clear() { R.clear(), h.clear(), h_prime.clear(), xi.clear(), xi_slope.clear(), radial.clear(); }
};

/// At n radii [m/s^2]: -DIV(T)/rho0.
struct ForceColumns {
  std::vector<double> r, theta, z;

  /// By (26) and (27), with J sigma = tau F^T symmetric where it is so but for the error of interpolation: as
  /// body_force() of one radius. tau, slopes: [c * n + k] of nine [Pa]; g: turn of the time; density: rho0 [kg/m^3].
  void set(const RadiusColumns& radii, const std::vector<double>& tau, const std::vector<double>& slopes, double g,
           double density);
};

}  // namespace assay
