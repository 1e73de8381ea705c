// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/foreign/written_inputs.hpp"

#include <gtest/gtest.h>

#include <vector>

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

TEST(GuardedArrays, AnEmptyArrayHasNoPlaceToWriteTo) {
  GuardedArrays arrays;
  const std::size_t none = arrays.add("STATEV", 0);
  arrays[none][0] = 1;
  EXPECT_EQ(arrays.broken_fence(), "writes past STATEV, which has 0 components");
}

TEST(GuardedArrays, LendOtherWordsForALookAtWhatIsReadThere) {
  GuardedArrays arrays(GuardedArrays::widest_fence);
  const std::size_t stress = arrays.add("STRESS", 6), state = arrays.add("STATEV", 3);
  std::vector<double> words(arrays.fence_words());
  for (std::size_t w = 0; w < words.size(); ++w) words[w] = static_cast<double>(w);
  arrays.lend(words);
  const auto behind_state = static_cast<std::size_t>(arrays[state][3]);
  EXPECT_EQ(arrays.place_of(behind_state).array, "STATEV");
  EXPECT_EQ(arrays.place_of(behind_state).index, 4);
  EXPECT_EQ(arrays.place_of(static_cast<std::size_t>(arrays[state][-1])).index, 0) << "before it";
  EXPECT_EQ(arrays.place_of(static_cast<std::size_t>(arrays[stress][8])).array, "STRESS");
  arrays[state][5] = -1;
  EXPECT_EQ(arrays.take_back(words), std::vector<std::size_t>{behind_state + 2});
  EXPECT_FALSE(arrays.broken_fence()) << "as before";
}

}  // namespace
}  // namespace assay::adapters::test_guarded_arrays
