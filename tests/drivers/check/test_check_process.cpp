// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check/check_process.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

namespace assay::drivers::test_check_process {
namespace {

CheckedMaterial one_task(const std::function<void(const CheckReporter&)>& work, double limit_s) {
  const CheckTask task{"clay", [&](const CheckReporter& reporter) {
                         reporter.begins("continuity");
                         work(reporter);
                         return CheckedMaterial{};
                       }};
  return check_in_processes({task}, {.limit_s = limit_s}).front();
}

// Whose calls all come back ends no process, and nothing is wrong with its equations.
TEST(CheckProcess, WhatIsNotDoneInTimeIsTooSlow) {
  const CheckedMaterial found = one_task([](const CheckReporter&) { ::sleep(10); }, 0.2);
  EXPECT_TRUE(found.unsuitable);
  EXPECT_NE(found.error.find("clay: the model returned from each call, but the tests were not done within 0.2 "
                             "s, in the test continuity: it is too slow to be judged"),
            std::string::npos)
      << found.error;
}

TEST(CheckProcess, WhatEndsItsProcessFails) {
  const CheckedMaterial found = one_task([](const CheckReporter&) { ::_exit(7); }, 60);
  EXPECT_FALSE(found.unsuitable);
  ASSERT_FALSE(found.report.diagnosis.empty());
  EXPECT_EQ(found.report.diagnosis[0].cause, check::causes::ends_process);
}

}  // namespace
}  // namespace assay::drivers::test_check_process
