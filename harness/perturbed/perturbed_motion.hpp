// SPDX-License-Identifier: BSD-3-Clause
// The motion of a code that makes a mistake: the balance of momentum of the problem with another load, another stress
// or another beginning, solved on a mesh that is fine enough for the difference from the right motion.
//
//   rho0 m x.. = DIV(P) + rho0 m b,   x(0) = X, x.(0) = v0
//
// Explicit, second order in the size of the elements and in the step. Mistakes that keep the symmetry of a polar motion
// need a mesh along one radius alone.
#pragma once

#include <memory>
#include <vector>

#include "harness/exact/exact_fields.hpp"
#include "harness/perturbed/mistake.hpp"
#include "harness/perturbed/perturbed_body.hpp"

namespace assay {

struct PerturbedProblem {
  ExactSolutionPtr exact;  ///< with stress, until `known`
  std::shared_ptr<const Material> material;
  Vector3 direction = Vector3::UnitX();  ///< of the material
  double density = 0;                    ///< rho0 [kg/m^3]
  double wave_speed = 0;                 ///< fastest on the way of the exact motion [m/s]
  bool moves_at_first = true;            ///< at t = 0
  bool has_acceleration = true;          ///< at some time
  bool has_static_force = true;          ///< b is more than the acceleration, somewhere
  /// Whether the code takes the body force of the point of the exact motion that is where its own point is now.
  bool force_at_current_position = false;
  double known = 0;  ///< last time of the exact solution; loads beyond are those of that time [s]
};

/// Positions of the nodes at times.
struct PerturbedHistory {
  std::vector<std::vector<Vector3>> x;  ///< [m]; fewer times than asked for where the motion ends in an element that is
                                        ///< turned inside out, or the material fails
};

class PerturbedMotion {
 public:
  /// times: ascending, from 0 on [s]. Throws MaterialFailure.
  PerturbedMotion(PerturbedProblem problem, std::unique_ptr<PerturbedBody> body, std::vector<double> times);
  ~PerturbedMotion();

  PerturbedHistory run(const Mistake& mistake) const;

  /// By how much the motion of a mistake differs at reference points X at time k, as a vector in the plane [m]: along
  /// the axes; of a ring along e_r and e_theta of the exact motion.
  std::vector<Vector3> difference(const PerturbedHistory& mistaken, const PerturbedHistory& right, std::size_t k,
                                  const std::vector<Vector3>& X) const;
  const std::vector<double>& times() const { return times_; }
  const PerturbedBody& body() const { return *body_; }

 private:
  class Table;
  struct State;
  void add_forces(const Mistake& mistake, double t, State& now) const;

  PerturbedProblem problem_;
  std::unique_ptr<PerturbedBody> body_;
  std::vector<double> times_, mass_;  ///< of the nodes: volume, or area of a radian [m^2]
  std::unique_ptr<const Table> table_;
  double step_ = 0;
};

}  // namespace assay
