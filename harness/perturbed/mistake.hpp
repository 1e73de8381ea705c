// SPDX-License-Identifier: BSD-3-Clause
// What a code may do differently from the problem that it is given.
#pragma once

#include "harness/numeric/tensor.hpp"

namespace assay {

/// Of the exact solution, at one point and time.
struct ForceParts {
  Vector3 x = Vector3::Zero();                             ///< position [m]
  Vector3 a = Vector3::Zero();                             ///< acceleration [m/s^2]
  Vector3 static_force = Vector3::Zero();                  ///< b - a = -DIV(P)/rho0 [m/s^2]
  Vector3 body_force() const { return a + static_force; }  ///< b (1) [m/s^2]
};

class ExactForce {
 public:
  virtual ~ExactForce() = default;
  /// At a reference point X [m] and a time [s], which is taken for one of the solution.
  virtual ForceParts at(const Vector3& X, double t) const = 0;
};

/// The functions answer as a right code does; a mistake overrides some of them.
class Mistake {
 public:
  virtual ~Mistake() = default;

  /// The velocity with which a point begins whose right one is v [m/s].
  virtual Vector3 initial_velocity(const Vector3& v) const { return v; }

  /// The time that body force and tractions are taken for [s].
  virtual double load_time(double t) const { return t; }

  /// Per mass [m/s^2], of the point X that is at x now [m]. t: as load_time says.
  virtual Vector3 body_force(const ExactForce& exact, const Vector3& X, const Vector3& /*x*/, double t) const {
    return exact.at(X, t).body_force();
  }

  /// First Piola-Kirchhoff stress for the right one [Pa].
  virtual Tensor stress(const Tensor& P, const Tensor& /*F*/) const { return P; }

  /// Density over the right one [1]. The body force stays one per mass.
  virtual double mass() const { return 1; }

  /// Rate of a force against the velocity, per mass [1/s].
  virtual double damping() const { return 0; }

  /// On the surface of the body, per reference area, for the right one T = P N [Pa]. normal: N, in the reference
  /// configuration.
  virtual Vector3 traction(const Vector3& T, const Vector3& /*normal*/) const { return T; }
};

}  // namespace assay
