// SPDX-License-Identifier: BSD-3-Clause
// A force against the velocity, which codes have to come to rest, or which their method has of itself.
#include "drivers/mistakes/mistake_family.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

struct Damping : SizedMistake {
  using SizedMistake::SizedMistake;
  double damping() const override { return size; }
};

}  // namespace

MistakeFamily mistake_damping() {
  return {.name = "damping",
          .doc = "velocities are damped, by a force or by the method itself",
          .right = 0,
          .small = 0.1,
          .range = {-20, 20},
          .plant = planted<Damping>,
          .words =
              [](double size) {
                return size > 0 ? "velocities are damped at a rate of " + rounded_text(size, 3) +
                                      " 1/s, by a force or by the method itself"
                                : "velocities grow by themselves at a rate of " + rounded_text(-size, 3) + " 1/s";
              },
          .of_methods = true};
}

}  // namespace assay::drivers
