// SPDX-License-Identifier: BSD-3-Clause
// Codes begin at rest where they have no way to prescribe a field of velocities.
#include "drivers/mistakes/mistake_family.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

struct InitialVelocityTimes : SizedMistake {
  using SizedMistake::SizedMistake;
  Vector3 initial_velocity(const Vector3& v) const override { return size * v; }
};

std::string initial_velocity_words(double size) {
  if (size == 0) return "there is no initial velocity: the body begins at rest";
  if (size == -1) return "the initial velocity has the wrong sign";
  return "the initial velocity is " + times_words(size) + " what it should be";
}

}  // namespace

MistakeFamily mistake_initial_velocity() {
  return {.name = "initial_velocity",
          .doc = "no initial velocity, half of it, its sign",
          .sizes = {0, 0.5, -1, 2},
          .small = 0.05,
          .plant = planted<InitialVelocityTimes>,
          .words = initial_velocity_words,
          .applies = [](const PerturbedProblem& problem) { return problem.moves_at_first; }};
}

}  // namespace assay::drivers
