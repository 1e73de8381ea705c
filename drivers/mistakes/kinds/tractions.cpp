// SPDX-License-Identifier: BSD-3-Clause
// On the surface of the body.
#include "drivers/mistakes/mistake_family.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

struct TractionsTimes : SizedMistake {
  using SizedMistake::SizedMistake;
  Vector3 traction(const Vector3& T, const Vector3&) const override { return size * T; }
};

std::string tractions_words(double size) {
  if (size == 0) return "the surface bears no tractions";
  if (size == -1) return "the tractions have the wrong sign";
  return "the tractions are " + times_words(size) + " what they should be";
}

}  // namespace

MistakeFamily mistake_tractions() {
  return {.name = "tractions",
          .doc = "no tractions on the surface, their sign, a factor",
          .sizes = {0, -1, 0.5, 2},
          .small = 0.05,
          .plant = planted<TractionsTimes>,
          .words = tractions_words,
          .applies = [](const PerturbedProblem& problem) { return problem.exact->motion()->bears_tractions(); }};
}

}  // namespace assay::drivers
