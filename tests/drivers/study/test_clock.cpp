// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/clock.hpp"

#include <gtest/gtest.h>

namespace assay::drivers::test_clock {
namespace {

TEST(Clock, TheMedianIsTheMiddleOrBetweenTheTwoInTheMiddle) {
  EXPECT_EQ(median({3}), 3);
  EXPECT_EQ(median({9, 1, 4}), 4);
  EXPECT_EQ(median({4, 1, 2, 100}), 3);
}

TEST(Clock, IsDisturbedWhereMostRepeatsWere) {
  ClockReadings clock;
  EXPECT_FALSE(is_disturbed(clock));
  clock.machine = "a machine, 4 cores";
  clock.others = {0.61, 0.1, 3};
  EXPECT_TRUE(is_disturbed(clock));
  clock.others = {0.59, 0.1, 3};
  EXPECT_FALSE(is_disturbed(clock));
}

TEST(Clock, CoresStandAtTheEndOfAMachinesName) {
  EXPECT_EQ(cores_of("AMD EPYC, 2 cores"), 2);
  EXPECT_EQ(cores_of("Intel, Inc., Xeon, 16 cores"), 16);
  EXPECT_EQ(cores_of("one, 1 core"), 1);
  for (const char* none : {"", "AMD EPYC", "AMD, many cores", "AMD, 2", "AMD, ", "AMD, 0 cores", "AMD, -3 cores"}) {
    EXPECT_EQ(cores_of(none), 1) << none;
  }
}

}  // namespace
}  // namespace assay::drivers::test_clock
