// SPDX-License-Identifier: BSD-3-Clause
// A slice between symmetry planes across z has the errors of the whole cube that it is a part of.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/drivers/process.hpp"
#include "tests/drivers/scratch_folder.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_planes_in_space {
namespace {

nlohmann::json result_of(const std::vector<std::string>& sets) {
  const ScratchFolder scratch;
  std::vector<std::string> words{"run", tree_folder() + "/configs/space/between_planes.yaml", "--quiet", "-o",
                                 scratch / "out"};
  for (const std::string& set : sets) words.insert(words.end(), {"--set", set});
  const Ending ending = assay(words);
  EXPECT_EQ(ending.status, 0) << ending.said;
  return nlohmann::json::parse(bytes_of(scratch / "out/result.json"));
}

TEST(LongPlanesInSpace, ASliceErrsAsTheWholeCube) {
  const auto slice = result_of({"time.step=0.01"});
  const auto whole = result_of({"time.step=0.01",
                                "body={domain: box, lower: [-1, -1, -1], upper: [1, 1, 1], per_cell: [2, 2, 2], "
                                "periodic: all}"});
  // between planes that are not half a wave apart; what the other half of the wave needs is not there
  const auto other = result_of({"time.step=0.01",
                                "body={domain: box, lower: [-1, -1, 0], upper: [1, 1, 0.5], per_cell: [2, 2, 2], "
                                "periodic: both}"});
  EXPECT_EQ(2 * slice["particles"].get<int>(), whole["particles"].get<int>());
  for (const char* norm : {"l2_half", "l2_end", "l2_max", "linf_max"}) {
    const double found = slice["error"][norm], wanted = whole["error"][norm];
    EXPECT_NEAR(found, wanted, 1e-12 * wanted) << norm;
  }
  const double l2 = slice["error"]["l2_max"], of_other = other["error"]["l2_max"];
  EXPECT_GT(std::abs(of_other - l2), 1e-3 * l2);
}

}  // namespace
}  // namespace assay::drivers::test_planes_in_space
