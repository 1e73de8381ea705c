// SPDX-License-Identifier: BSD-3-Clause
// The mass of a particle, where the body force is one per mass.
#include "drivers/mistakes/mistake_family.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

struct MassTimes : Mistake {
  explicit MassTimes(double of_size) : size(of_size) {}
  double mass() const override { return size; }
  double size;
};

}  // namespace

MistakeFamily mistake_mass() {
  return {.name = "mass",
          .doc = "the mass is too large or too small by a factor",
          .sizes = {0.5, 2},
          .small = 0.05,
          .range = {0.1, 10},
          .plant = [](double size) -> std::unique_ptr<Mistake> { return std::make_unique<MassTimes>(size); },
          .words = [](double size) { return "the mass is " + times_words(size) + " what it should be"; }};
}

}  // namespace assay::drivers
