// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/output/errors_csv.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace assay::drivers::test_errors_csv {
namespace {

TEST(ErrorsCsv, has_one_column_a_field_and_norm) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(errors_csv({{0.5, {1, 2}, 3, {4, 5}, {6, 7}, {8, 9}, {10, nan}}}),
            "t,l2,linf,rms36,velocity_l2,velocity_linf,deformation_gradient_l2,deformation_gradient_linf,"
            "jacobian_l2,jacobian_linf,stress_l2,stress_linf\n"
            "0.5,1,2,3,4,5,6,7,8,9,10,\n");
}

TEST(ErrorsCsv, the_history_of_the_displacement_is_read_back) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::string text = errors_csv(
      {{0, {0, 0}, 0, {}, {}, {}, {}}, {0.5, {1.25, 2}, 3, {}, {}, {}, {}}, {1, {nan, 1}, 1, {}, {}, {}, {}}});
  using History = std::vector<std::array<double, 2>>;
  EXPECT_EQ(displacement_history(text), (History{{0, 0}, {0.5, 1.25}}));
  EXPECT_EQ(displacement_history(text.substr(0, text.find("1.25") + 2)), (History{{0, 0}}));
  EXPECT_TRUE(displacement_history("").empty());
  EXPECT_TRUE(displacement_history("x,y,z\n1,2,3\n").empty());
}

}  // namespace
}  // namespace assay::drivers::test_errors_csv
