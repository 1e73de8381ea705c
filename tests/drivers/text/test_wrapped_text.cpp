// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/text/wrapped_text.hpp"

#include <gtest/gtest.h>

namespace assay::drivers::test_wrapped_text {
namespace {

TEST(WrappedText, BreaksBetweenWords) {
  EXPECT_EQ(wrapped("one two three", "- ", "  ", 9), "- one two\n  three\n");
  EXPECT_EQ(wrapped("one", "", "", 9), "one\n");
  EXPECT_EQ(wrapped("", "- ", "  ", 9), "- \n");
}

TEST(WrappedText, LetsALongWordStandAlone) {
  EXPECT_EQ(wrapped("a abcdefghijkl b", "", " ", 5), "a\n abcdefghijkl\n b\n");
}

}  // namespace
}  // namespace assay::drivers::test_wrapped_text
