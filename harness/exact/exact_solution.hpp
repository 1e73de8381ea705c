// SPDX-License-Identifier: BSD-3-Clause
// A motion with the stress that a material answers it with: what body force, tractions and errors are made of.
#pragma once

#include <memory>
#include <variant>

#include "harness/exact/box_stress.hpp"
#include "harness/exact/homogeneous_stress.hpp"
#include "harness/exact/response.hpp"
#include "harness/motion/motion.hpp"

namespace assay {

class ExactSolution {
 public:
  /// Of a polar motion: tau(xi, t) of the vortex, tau(R, t) of the twisting ring. density: rho0 [kg/m^3].
  ExactSolution(Motion motion, double density, std::shared_ptr<const Response> response)
      : motion_(std::move(motion)), density_(density), source_(std::move(response)) {}
  /// Of a motion whose F is the same everywhere.
  ExactSolution(Motion motion, double density, std::shared_ptr<HomogeneousStress> stress)
      : motion_(std::move(motion)), density_(density), source_(std::move(stress)) {}

  /// Of the axis-aligned motion and the bar.
  ExactSolution(Motion motion, double density, std::shared_ptr<BoxStress> stress)
      : motion_(std::move(motion)), density_(density), source_(std::move(stress)) {}

  const Motion& motion() const { return motion_; }
  ExactState state(const Vector3& X, double t) const { return state_at(motion_, X, t); }

  /// P, sigma and b at a reference point. Where the response or the history goes forward only, times must not descend.
  ExactStress stress(const Vector3& X, double t) const;

  /// Null where the stress is something else.
  const std::shared_ptr<HomogeneousStress>* homogeneous() const {
    return std::get_if<std::shared_ptr<HomogeneousStress>>(&source_);
  }
  const std::shared_ptr<BoxStress>* box() const { return std::get_if<std::shared_ptr<BoxStress>>(&source_); }
  const std::shared_ptr<const Response>* response() const {
    return std::get_if<std::shared_ptr<const Response>>(&source_);
  }

 private:
  ExactStress ring_stress(const Vector3& X, double t) const;

  Motion motion_;
  double density_;
  std::variant<std::shared_ptr<const Response>, std::shared_ptr<HomogeneousStress>, std::shared_ptr<BoxStress>> source_;
};

}  // namespace assay
