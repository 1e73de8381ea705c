// SPDX-License-Identifier: BSD-3-Clause
// b = a - DIV(P)/rho0 (1) with another part of the stress.
#include "drivers/mistakes/mistake_family.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

struct StressTermTimes : SizedMistake {
  using SizedMistake::SizedMistake;
  Vector3 body_force(const ExactForce& exact, const Vector3& X, const Vector3&, double t) const override {
    const ForceParts parts = exact.at(X, t);
    return parts.a + size * parts.static_force;
  }
};

std::string stress_term_words(double size) {
  if (size == 0) return "the body force lacks its stress term, the divergence";
  if (size == -1) return "the stress term of the body force has the wrong sign";
  return "the stress term of the body force is " + times_words(size) + " what it should be";
}

}  // namespace

MistakeFamily mistake_stress_term() {
  return {.name = "stress_term",
          .doc = "the divergence of the stress in b is missing, or has the wrong sign",
          .sizes = {0, -1, 2},
          .small = 0.05,
          .plant = planted<StressTermTimes>,
          .words = stress_term_words,
          .applies = [](const PerturbedProblem& problem) { return problem.has_static_force; }};
}

}  // namespace assay::drivers
