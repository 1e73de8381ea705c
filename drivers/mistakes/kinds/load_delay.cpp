// SPDX-License-Identifier: BSD-3-Clause
// A load of the step before, or of the next one.
#include "drivers/mistakes/mistake_family.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

struct LoadLate : SizedMistake {
  using SizedMistake::SizedMistake;
  double load_time(double t) const override { return t - size; }
};

}  // namespace

MistakeFamily mistake_load_delay() {
  return {.name = "load_delay",
          .doc = "loads are those of an earlier or a later time, as of the step before",
          .right = 0,
          .small = 0.01,
          .range = {-0.2, 0.2},
          .plant = planted<LoadLate>,
          .words = [](double size) {
            return "the loads are " + rounded_text(std::abs(size), 3) + (size > 0 ? " s late" : " s early");
          }};
}

}  // namespace assay::drivers
