// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/output/time_list.hpp"

#include <gtest/gtest.h>

#include "drivers/system/input_error.hpp"
#include "tests/drivers/scratch_folder.hpp"

namespace assay::drivers::test_time_list {
namespace {

using Times = std::vector<double>;

std::string refusal(const std::string& given) {
  try {
    read_times(given);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(TimeList, OfNumbersInTheirOrder) {
  EXPECT_EQ(read_times("0,.1,.2"), (Times{0, .1, .2}));
  EXPECT_EQ(read_times("1, 0.5"), (Times{1, .5}));
  EXPECT_EQ(read_times("3"), Times{3});
  EXPECT_TRUE(refusal("0,x").starts_with("--times: 'x' is no finite number")) << refusal("0,x");
  EXPECT_TRUE(refusal("0,-1").starts_with("--times: negative")) << refusal("0,-1");
  EXPECT_TRUE(refusal("0,").starts_with("--times: ''")) << refusal("0,");
  EXPECT_TRUE(refusal("0,.inf").starts_with("--times: ")) << refusal("0,.inf");
}

TEST(TimeList, OfFiles) {
  const ScratchFolder scratch;
  EXPECT_EQ(read_times(scratch.write("a", "# s\n0\n.5\r\n1e0")), (Times{0, .5, 1}));
  EXPECT_EQ(read_times(scratch.write("b.csv", "t\n0\n2\n")), (Times{0, 2}));
  EXPECT_EQ(read_times(scratch.write("list", "0,.5, 1\n2\n")), (Times{0, .5, 1, 2}));
  const auto said = [&](const std::string& text) {
    const std::string name = scratch.write("c", text);
    const std::string what = refusal(name);
    EXPECT_TRUE(what.starts_with(name)) << what;
    return what.substr(std::min(what.size(), name.size()));
  };
  EXPECT_TRUE(said("0\nx\n").starts_with(":2:1: 'x' is no finite number"));
  EXPECT_TRUE(said("0\n-1\n").starts_with(":2:1: negative"));
  EXPECT_TRUE(said("0\n1,x\n").starts_with(":2:3: 'x' is no finite number"));
  EXPECT_TRUE(said("t\n-1\n").starts_with(": t: negative"));
  EXPECT_TRUE(said("").starts_with(": holds no time"));
  EXPECT_TRUE(refusal(scratch / "missing").find("neither a list of numbers") != std::string::npos);
}

}  // namespace
}  // namespace assay::drivers::test_time_list
