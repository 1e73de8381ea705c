// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/response_source.hpp"

#include <gtest/gtest.h>

namespace assay::drivers::test_sheet_line {
namespace {

TEST(SheetLine, SaysWhatMakesALongSheetShorter) {
  const std::string said = long_sheet_sentence(250, 1e-10);
  EXPECT_NE(said.find("may take up to 4 min 10 s, often a third of it or less; shorter"), std::string::npos) << said;
  EXPECT_NE(said.find("force.tolerance: 1e-07 in place of 1e-10"), std::string::npos) << said;
  EXPECT_NE(said.find("time.end"), std::string::npos) << said;
  EXPECT_NE(long_sheet_sentence(250, 1e-12).find("1e-07 in place of 1e-12"), std::string::npos);
  EXPECT_NE(long_sheet_sentence(250, 1e-4).find("0.01 in place of 0.0001"), std::string::npos);
  EXPECT_EQ(long_sheet_sentence(250, 1e-2).find("in place of"), std::string::npos);
  EXPECT_NE(long_sheet_sentence(250, 1e-6).find("0.001 in place of 1e-06"), std::string::npos);
}

/// The work that is planned grows on the way: a time that was told is corrected when it is over.
TEST(Forecast, IsCorrectedWhenItIsExceeded) {
  Forecast forecast;
  EXPECT_FALSE(forecast.told(1, 0.01)) << "too early";
  EXPECT_FALSE(forecast.told(6, 0.5)) << "short";
  EXPECT_FALSE(forecast.was_told());
  EXPECT_EQ(forecast.told(6, 0.125), 48);
  EXPECT_FALSE(forecast.told(40, 0.1)) << "not over";
  EXPECT_EQ(forecast.told(50, 0.1), 500);
  EXPECT_EQ(forecast.told(510, 0.99), 765) << "not at each update from then on";
  EXPECT_FALSE(forecast.told(600, 0.995));
  EXPECT_TRUE(forecast.was_told());
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
