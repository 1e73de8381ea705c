// SPDX-License-Identifier: BSD-3-Clause
// b is written along e_r and e_theta at the current angle Theta + alpha (25).
#include "drivers/mistakes/mistake_family.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

struct ForceTurned : SizedMistake {
  using SizedMistake::SizedMistake;
  Vector3 body_force(const ExactForce& exact, const Vector3& X, const Vector3&, double t) const override {
    const ForceParts parts = exact.at(X, t);
    const double alpha = std::atan2(X.x() * parts.x.y() - X.y() * parts.x.x(), X.dot(parts.x));
    return rotation_about_z((size - 1) * alpha) * parts.body_force();
  }
};

std::string force_rotation_words(double size) {
  if (size == 0) return "the body force does not turn with the body: it lacks the rotation by alpha";
  if (size == 2) return "the body force is turned twice by alpha";
  return "the body force is turned by " + times_words(size) + " alpha";
}

}  // namespace

MistakeFamily mistake_force_rotation() {
  return {.name = "force_rotation",
          .doc = "b lacks the rotation by alpha, or is turned by it twice",
          .sizes = {0, 2, -1},
          .plant = planted<ForceTurned>,
          .words = force_rotation_words,
          .applies = [](const PerturbedProblem& problem) { return problem.exact->motion()->polar() != nullptr; }};
}

}  // namespace assay::drivers
