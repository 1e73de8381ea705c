// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/foreign/guarded_arrays.hpp"

#include <gtest/gtest.h>

namespace assay::adapters::test_guarded_arrays {
namespace {

TEST(GuardedArrays, TellWhichArrayWasLeft) {
  GuardedArrays arrays;
  const std::size_t stress = arrays.add("STRESS", 6), state = arrays.add("STATEV", 3);
  EXPECT_EQ(arrays.size(state), 3u);
  arrays.fill(stress, 2);
  EXPECT_EQ(arrays[stress][5], 2);
  EXPECT_FALSE(arrays.broken_fence());
  arrays[state][3] = 0;
  EXPECT_EQ(arrays.broken_fence(), "writes past STATEV, which has 3 components");
  EXPECT_FALSE(arrays.broken_fence()) << "repaired";
  arrays[stress][-1] = 0;
  EXPECT_EQ(arrays.broken_fence(), "writes before STRESS");
  arrays[state][-1] = 0;
  EXPECT_EQ(arrays.broken_fence(), "writes before STATEV");
}

TEST(GuardedArrays, FencesKnownToStandAreNotLookedAt) {
  GuardedArrays arrays;
  const std::size_t stress = arrays.add("STRESS", 6), strain = arrays.add("STRAN", 6);
  EXPECT_EQ(arrays.from(strain).data(), arrays[strain]);
  arrays[strain][6] = 0;
  EXPECT_FALSE(arrays.broken_fence(strain));
  arrays[stress][6] = 0;
  EXPECT_EQ(arrays.broken_fence(strain), "writes past STRESS, which has 6 components");
}

TEST(GuardedArrays, AnEmptyArrayHasAPlaceToPointTo) {
  GuardedArrays arrays;
  const std::size_t none = arrays.add("STATEV", 0);
  arrays[none][0] = 1;
  EXPECT_FALSE(arrays.broken_fence());
  arrays[none][1] = 1;
  EXPECT_EQ(arrays.broken_fence(), "writes past STATEV, which has 0 components");
}

}  // namespace
}  // namespace assay::adapters::test_guarded_arrays
