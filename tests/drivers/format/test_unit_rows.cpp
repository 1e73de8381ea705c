// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/format/unit_rows.hpp"

#include <gtest/gtest.h>

namespace assay::drivers::test_unit_rows {
namespace {

TEST(UnitRows, AreWrittenByTheirWord) {
  double value = 1e6;
  const YamlRow row = unit_row("stress", value, unit_words("Pa"));
  EXPECT_EQ(row.written(), "MPa");
  value = 2e6;
  EXPECT_EQ(row.written(), "") << "no word has it";
}

}  // namespace
}  // namespace assay::drivers::test_unit_rows
