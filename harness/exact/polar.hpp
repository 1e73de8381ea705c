// SPDX-License-Identifier: BSD-3-Clause
// The body force of a ring that turns, (24) to (33), from the baseline response of any material.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "harness/exact/exact_fields.hpp"
#include "harness/motion/ring_kinematics.hpp"

namespace assay {

/// tau and (d tau / d xi)_t at a point [Pa].
struct BaselineStress {
  Tensor tau, dtau_dxi;
};

/// With J sigma = tau F^T symmetric: interpolation is only to its error, by which forms of the divergence would differ.
/// A stress further from symmetry is the model's own, and stays.
BaselineStress balanced(const RingProfile& profile, double g, const Tensor& tau, const Tensor& dtau_dxi);

/// DIV(T) in the first Piola-Kirchhoff form, (26) and (27), with (d tau / d R)_t = (d tau / d xi)_t xi' [N/m^3].
Polar divergence_piola(const RingProfile& profile, double g, double R, const Tensor& tau, const Tensor& dtau_dxi);

/// b = a - DIV(T)/rho0 at the radius R with its profile and the amplitude of the time, (32) and (33) with the inertia
/// term + R g'' h [m/s^2]; zero outside the ring.
Polar body_force(const RingProfile& profile, const AmplitudeValue& g, double density, double R, const Tensor& tau,
                 const Tensor& dtau_dxi);

/// The slice of a polar solution: its parts lie between the ring's edges and between the fronts of the material.
/// density: rho0 [kg/m^3].
std::unique_ptr<const ExactSlice> slice_of_ring(const ExactSolution& solution, double density, double t);

/// Points of a polar solution: what depends on R alone is computed once for each radius of some hundred points.
std::unique_ptr<const ExactPlaces> places_of_ring(const Motion& motion, std::vector<Vector3> X);

/// Fixed reference points of a ring, grouped by radius: what depends on R alone is computed once for each radius.
struct RingPoints {
  std::vector<double> radius;                ///< distinct radii, ascending [m]
  std::vector<std::uint32_t> ring;           ///< of each point: index of its radius
  std::vector<double> cos_theta, sin_theta;  ///< of each point: reference angle Theta

  RingPoints() = default;
  /// X, Y: reference positions [m].
  RingPoints(std::span<const double> X, std::span<const double> Y);
};

}  // namespace assay
