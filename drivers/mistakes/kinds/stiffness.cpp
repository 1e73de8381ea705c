// SPDX-License-Identifier: BSD-3-Clause
// The modulus of the model, with the body force of the right one.
#include "drivers/mistakes/mistake_family.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

struct StiffnessTimes : Mistake {
  explicit StiffnessTimes(double of_size) : size(of_size) {}
  Tensor stress(const Tensor& P, const Tensor&) const override { return size * P; }
  double size;
};

}  // namespace

MistakeFamily mistake_stiffness() {
  return {.name = "stiffness",
          .doc = "all stresses are too large or too small by a factor, as of a wrong modulus",
          .sizes = {0.5, 2},
          .small = 0.05,
          .range = {0.1, 10},
          .plant = [](double size) -> std::unique_ptr<Mistake> { return std::make_unique<StiffnessTimes>(size); },
          .words =
              [](double size) {
                return "all stresses are " + times_words(size) + " what they should be, as of a wrong modulus";
              }};
}

}  // namespace assay::drivers
