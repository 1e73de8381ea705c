// SPDX-License-Identifier: BSD-3-Clause
// Runs of the scenes of configs/, silent, on one thread.
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "drivers/verbs/verbs.hpp"
#include "tests/drivers/scratch_folder.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers {

/// `scene`: its path below configs/, without .yaml. `sets`: after those that keep it short and expect nothing.
inline RunOptions quiet_run(const std::string& scene, const std::string& out, const std::vector<std::string>& sets) {
  RunOptions options;
  options.scene = tree_folder() + "/configs/" + scene + ".yaml";
  options.out = out;
  options.threads = 1;
  options.verbosity = Verbosity::quiet;
  options.sets = {"expect={}"};
  options.sets.insert(options.sets.end(), sets.begin(), sets.end());
  return options;
}

inline nlohmann::json result_in(const std::string& folder) {
  return nlohmann::json::parse(bytes_of(folder + "/result.json"));
}

/// result.json of a run that does as it should.
inline nlohmann::json result_of_run(const std::string& scene, const std::vector<std::string>& sets) {
  const ScratchFolder scratch;
  EXPECT_EQ(run(quiet_run(scene, scratch / "out", sets)), 0) << scene;
  return result_in(scratch / "out");
}

}  // namespace assay::drivers
