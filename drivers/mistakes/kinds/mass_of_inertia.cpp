// SPDX-License-Identifier: BSD-3-Clause
// The mass that is accelerated, where loads are those of the right one.
#include "drivers/mistakes/mistake_family.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

struct MassOfInertiaTimes : SizedMistake {
  using SizedMistake::SizedMistake;
  double mass() const override { return size; }
  Vector3 body_force(const ExactForce& exact, const Vector3& X, const Vector3& /*x*/, double t) const override {
    return exact.at(X, t).body_force() / size;
  }
};

}  // namespace

MistakeFamily mistake_mass_of_inertia() {
  return {.name = "mass_of_inertia",
          .doc =
              "the mass that is accelerated is too large or too small by a factor, and the one under the body force is "
              "right",
          .sizes = {0.5, 2},
          .small = 0.05,
          .range = {0.1, 10},
          .plant = planted<MassOfInertiaTimes>,
          .words = [](double size) {
            return "the mass that is accelerated is " + times_words(size) + " that under the body force";
          }};
}

}  // namespace assay::drivers
