// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/output/errors_csv.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace assay::drivers {
namespace {

TEST(ErrorsCsv, has_one_column_a_field_and_norm) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(errors_csv({{0.5, {1, 2}, 3, {4, 5}, {6, 7}, {8, 9}, {10, nan}}}),
            "t,l2,linf,rms36,velocity_l2,velocity_linf,deformation_gradient_l2,deformation_gradient_linf,"
            "jacobian_l2,jacobian_linf,stress_l2,stress_linf\n"
            "0.5,1,2,3,4,5,6,7,8,9,10,\n");
}

}  // namespace
}  // namespace assay::drivers
