// SPDX-License-Identifier: BSD-3-Clause
// The modulus of the model, with the body force of the right one.
#include "drivers/mistakes/mistake_family.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

struct StiffnessTimes : SizedMistake {
  using SizedMistake::SizedMistake;
  Tensor stress(const Tensor& P, const Tensor&) const override { return size * P; }
};

}  // namespace

MistakeFamily mistake_stiffness() {
  return {.name = "stiffness",
          .doc = "all stresses are too large or too small by a factor, as of a wrong modulus",
          .sizes = {0.5, 2},
          .small = 0.05,
          .range = {0.1, 10},
          .plant = planted<StiffnessTimes>,
          .words = [](double size) {
            return "all stresses are " + times_words(size) + " what they should be, as of a wrong modulus";
          }};
}

}  // namespace assay::drivers
