// SPDX-License-Identifier: BSD-3-Clause
// b = a - DIV(P)/rho0 (1) with another part of a.
#include "drivers/mistakes/mistake_family.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

struct InertiaTimes : SizedMistake {
  using SizedMistake::SizedMistake;
  Vector3 body_force(const ExactForce& exact, const Vector3& X, const Vector3&, double t) const override {
    const ForceParts parts = exact.at(X, t);
    return size * parts.a + parts.static_force;
  }
};

std::string inertia_words(double size) {
  if (size == 0) return "the body force lacks its inertia term, the acceleration";
  if (size == -1) return "the inertia term of the body force has the wrong sign";
  return "the inertia term of the body force is " + times_words(size) + " what it should be";
}

}  // namespace

MistakeFamily mistake_inertia_term() {
  return {.name = "inertia_term",
          .doc = "the acceleration in b is missing, or has the wrong sign",
          .sizes = {0, -1, 2},
          .small = 0.05,
          .plant = planted<InertiaTimes>,
          .words = inertia_words,
          .applies = [](const PerturbedProblem& problem) { return problem.has_acceleration; }};
}

}  // namespace assay::drivers
