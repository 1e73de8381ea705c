// SPDX-License-Identifier: BSD-3-Clause
// All of b.
#include "drivers/mistakes/mistake_family.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

struct BodyForceTimes : SizedMistake {
  using SizedMistake::SizedMistake;
  Vector3 body_force(const ExactForce& exact, const Vector3& X, const Vector3&, double t) const override {
    return size * exact.at(X, t).body_force();
  }
};

std::string body_force_words(double size) {
  if (size == 0) return "there is no body force";
  if (size == -1) return "the body force has the wrong sign";
  return "the body force is " + times_words(size) + " what it should be";
}

}  // namespace

MistakeFamily mistake_body_force() {
  return {
      .name = "body_force",
      .doc = "no body force, its sign, a factor",
      .sizes = {0, -1, 0.5, 2},
      .small = 0.05,
      .plant = planted<BodyForceTimes>,
      .words = body_force_words,
      .applies = [](const PerturbedProblem& problem) { return problem.has_acceleration || problem.has_static_force; }};
}

}  // namespace assay::drivers
