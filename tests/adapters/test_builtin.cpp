// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/builtin.hpp"

#include <gtest/gtest.h>

#include "harness/material/material.hpp"

namespace assay::adapters::test_builtin {
namespace {

TEST(Builtin, TablesAreFreeOfDefectsAndFoundByName) {
  ASSERT_FALSE(builtin_tables().empty());
  for (const assay_material* table : builtin_tables()) {
    EXPECT_EQ(defect_of(table), std::nullopt) << table->name;
    EXPECT_EQ(builtin_table(table->name), table);
  }
  EXPECT_NE(builtin_table("neo_hookean"), nullptr);
  EXPECT_EQ(builtin_table("neo_hookea"), nullptr);
  EXPECT_EQ(builtin_table(""), nullptr);
}

}  // namespace
}  // namespace assay::adapters::test_builtin
