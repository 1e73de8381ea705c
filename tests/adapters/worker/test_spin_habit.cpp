// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/worker/hand_over.hpp"

#include <gtest/gtest.h>

namespace assay::adapters::test_spin_habit {
namespace {

/// Calls of so many that looked, where answers come in time or do not.
int looks(SpinHabit& habit, int calls, bool come) {
  int count = 0;
  for (int k = 0; k < calls; ++k) {
    if (habit.look() == 0) continue;
    ++count;
    habit.note(come);
  }
  return count;
}

TEST(SpinHabit, LooksAsLongAsAnswersCome) {
  SpinHabit habit;
  EXPECT_EQ(looks(habit, 1000, true), 1000);
}

TEST(SpinHabit, RestsWhereTheyDoNotAndTriesAgain) {
  SpinHabit habit;
  const int period = SpinHabit::trials + SpinHabit::rest;
  EXPECT_EQ(looks(habit, 10 * period, false), 10 * SpinHabit::trials);
  looks(habit, SpinHabit::trials + SpinHabit::rest - 1, false);
  EXPECT_EQ(looks(habit, 1000, true), 999);
}

TEST(SpinHabit, OneLateAnswerOfManyChangesNothing) {
  SpinHabit habit;
  for (int k = 0; k < 1000; ++k) {
    ASSERT_GT(habit.look(), 0u) << k;
    habit.note(k % SpinHabit::trials != 0);
  }
}

}  // namespace
}  // namespace assay::adapters::test_spin_habit
