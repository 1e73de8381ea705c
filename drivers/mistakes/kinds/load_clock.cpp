// SPDX-License-Identifier: BSD-3-Clause
// The clock of the load runs at another rate than that of the code.
#include "drivers/mistakes/mistake_family.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

struct LoadClock : SizedMistake {
  using SizedMistake::SizedMistake;
  double load_time(double t) const override { return size * t; }
};

}  // namespace

MistakeFamily mistake_load_clock() {
  return {.name = "load_clock",
          .doc = "the clock of the loads is fast or slow",
          .small = 0.02,
          .range = {0.5, 2},
          .plant = planted<LoadClock>,
          .words = [](double size) { return "the clock of the loads runs at " + times_words(size) + " its rate"; }};
}

}  // namespace assay::drivers
