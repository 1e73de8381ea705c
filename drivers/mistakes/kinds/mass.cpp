// SPDX-License-Identifier: BSD-3-Clause
// The mass of a particle, where the body force is one per mass.
#include "drivers/mistakes/mistake_family.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

struct MassTimes : SizedMistake {
  using SizedMistake::SizedMistake;
  double mass() const override { return size; }
};

}  // namespace

MistakeFamily mistake_mass() {
  return {.name = "mass",
          .doc = "the mass is too large or too small by a factor",
          .sizes = {0.5, 2},
          .small = 0.05,
          .range = {0.1, 10},
          .plant = planted<MassTimes>,
          .words = [](double size) { return "the mass is " + times_words(size) + " what it should be"; }};
}

}  // namespace assay::drivers
