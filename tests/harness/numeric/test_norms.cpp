// SPDX-License-Identifier: BSD-3-Clause
#include "harness/numeric/norms.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace assay::test_norms {
namespace {

TEST(Norms, WeighByVolume) {
  NormAccumulator norm;
  norm.add(1, 4);
  norm.add(3, 0);
  EXPECT_DOUBLE_EQ(norm.l2(), 1);
  EXPECT_DOUBLE_EQ(norm.linf(), 2);
}

TEST(Norms, KeepANaN) {
  NormAccumulator norm;
  norm.add(1, std::numeric_limits<double>::quiet_NaN());
  norm.add(1, 1);
  EXPECT_TRUE(std::isnan(norm.l2()));
  EXPECT_TRUE(std::isnan(norm.linf()));
}

TEST(Norms, NothingIsZero) { EXPECT_EQ(NormAccumulator().l2(), 0); }

TEST(Norms, OrderOfAPowerLaw) { EXPECT_NEAR(observed_order(0.1, 0.04, 0.05, 0.01), 2, 1e-12); }

}  // namespace
}  // namespace assay::test_norms
