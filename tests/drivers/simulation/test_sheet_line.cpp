// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/sheet_line.hpp"

#include <gtest/gtest.h>

namespace assay::drivers::test_sheet_line {
namespace {

TEST(SheetLine, SaysWhatMakesALongSheetShorter) {
  const std::string said = long_sheet_sentence(250, 1e-10);
  EXPECT_NE(said.find("may take up to 4 min 10 s, often a third of it or less; shorter"), std::string::npos) << said;
  EXPECT_NE(said.find("force.tolerance: 1e-07 in place of 1e-10"), std::string::npos) << said;
  EXPECT_NE(said.find("time.end"), std::string::npos) << said;
  EXPECT_NE(long_sheet_sentence(250, 1e-12).find("1e-07 in place of 1e-12"), std::string::npos);
  EXPECT_NE(long_sheet_sentence(250, 1e-6).find("0.001 in place of 1e-06"), std::string::npos);
}

/// A call is cheap, and nothing is written where there is no terminal.
TEST(SheetLine, TakesAnyProgress) {
  SheetLine line(1e-10, true);
  using Stage = SheetProgress::Stage;
  testing::internal::CaptureStderr();
  for (const Stage stage : {Stage::bands, Stage::histories, Stage::error}) {
    for (const double planned : {0.0, 12.0}) line.update({stage, planned / 2, planned});
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace assay::drivers::test_sheet_line
