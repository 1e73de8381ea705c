// SPDX-License-Identifier: BSD-3-Clause
// A column that is shared changes for none but the one who changes it.
#include "drivers/judge/shared_column.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace assay::drivers::test_shared_column {
namespace {

using Column = SharedColumn<double>;

TEST(SharedColumn, IsAVector) {
  Column column;
  EXPECT_TRUE(column.empty());
  column.push_back(1), column.push_back(2);
  column[1] = 3;
  double sum = 0;
  for (const double value : std::as_const(column)) sum += value;
  EXPECT_EQ(sum, 4);
  EXPECT_EQ(column.size(), 2u);
  EXPECT_TRUE(Column(std::vector<double>()).empty());
}

TEST(SharedColumn, OfWhichACopyIsChangedStaysAsItIs) {
  const Column first(std::vector<double>{1, 2});
  Column copy = first, equal(std::vector<double>{1, 2}), other(std::vector<double>{1, 4});
  equal.share(first), other.share(first);
  EXPECT_EQ(&std::as_const(equal)[0], &first[0]);
  EXPECT_NE(&std::as_const(other)[0], &first[0]);
  copy[0] = 7, equal.push_back(3);
  EXPECT_EQ(first[0], 1);
  EXPECT_EQ(first.size(), 2u);
  EXPECT_EQ(copy[0], 7);
}

}  // namespace
}  // namespace assay::drivers::test_shared_column
