// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/drivers/misdeeds.hpp"

namespace assay::drivers::test_own_names {
namespace {

// What it calls by such a name is its own.
TEST(OwnNames, OfAModelStandBeforeThoseOfOtherLibraries) {
  if (sanitized()) GTEST_SKIP() << "a sanitizer refuses libraries that are bound deeply";
  const Misdeeds the;
  for (const char* isolation : {"none", "worker"}) {
    std::vector<std::string> words = the.run_words(built("tests/plugins/own_names.so"));
    words.insert(words.end(), {"--set", std::string("material.isolation=") + isolation});
    const Ending run = the.program(words, "");
    EXPECT_EQ(run.status, 0) << isolation << ": " << run.said;
  }
}

}  // namespace
}  // namespace assay::drivers::test_own_names
