// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/analysis/clock.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

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

/// One case of runs of these lengths [s], beside others that kept so many of 4 cores busy.
StudyCase timed(const std::vector<double>& lengths, const std::vector<double>& others) {
  StudyCase one;
  one.clock.alone = true;
  one.clock.wall_s = lengths, one.clock.others = others, one.clock.machine = "a machine, 4 cores";
  return one;
}

StudyFindings study_of(std::vector<StudyCase> cases) {
  StudyFindings findings;
  findings.cost_unit = "s";
  findings.cases = std::move(cases);
  return findings;
}

TEST(Load, IsTheShareOfAllProcessorsByTheLengthOfTheRuns) {
  const StudyFindings busy = study_of({timed({1, 1, 2}, {4, 4, 2}), timed({6}, {0})});
  const MeasuredLoad load = load_of(busy);
  EXPECT_DOUBLE_EQ(load.share, 0.4);
  EXPECT_EQ(load.timed, 2);
  EXPECT_EQ(load.disturbed, 1);
  EXPECT_TRUE(load.noticeable());
  EXPECT_EQ(load_sentence(busy),
            "times were measured while other programs used 40 % of the processors, and more than 15 % beside 1 of 2 "
            "cases: compare them with care");
}

TEST(Load, IsNoticeableBeyondTheBoundAloneAndOnlyOfTimes) {
  EXPECT_EQ(load_sentence(study_of({timed({1}, {0.59})})), "");
  EXPECT_NE(load_sentence(study_of({timed({1}, {0.61})})), "");
  EXPECT_EQ(load_sentence(study_of({timed({1, 1, 1}, {0, 0.59, 4})})), "") << "the median counts, as it does for costs";
  EXPECT_NE(load_sentence(study_of({timed({1}, {4}), timed({100}, {0})})), "") << "one case was disturbed";
  StudyFindings counted = study_of({timed({1}, {4})});
  counted.cost_unit = "";
  EXPECT_EQ(load_sentence(counted), "");
}

TEST(Load, IsNoneOfWhatWasNotTimedAlone) {
  StudyCase beside = timed({1}, {4});
  beside.clock.alone = false;
  for (const StudyFindings& none : {study_of({}), study_of({beside}), study_of({timed({}, {})})}) {
    EXPECT_EQ(load_of(none).timed, 0);
    EXPECT_FALSE(load_of(none).noticeable());
    EXPECT_EQ(load_sentence(none), "");
  }
  EXPECT_EQ(load_of(study_of({timed({1}, {9})})).share, 1) << "clocks of the machine tick in hundredths";
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
