// SPDX-License-Identifier: BSD-3-Clause
// Short runs on several threads, as the program does them: what the thread sanitizer is shown.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/house/tree.hpp"
#include "tests/support/built.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::test_threads {
namespace {

using namespace assay::house;
namespace fs = std::filesystem;

/// Tests run side by side: each has its own folder.
std::string errors_of_run(const std::string& scene, int run, const std::string& more) {
  const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
  const fs::path folder = fs::path(built()) / "tests" / ("threads_" + test + std::to_string(run));
  fs::remove_all(folder);
  const Outcome outcome = run_assay(
      "run '" + tree_folder() + "/" + scene + "' -o '" + folder.string() +
      "' --threads 4 --quiet --set time.end=0.02 --set expect={} --set 'output={errors: 4, particles: 1}'" + more);
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  std::ifstream in(folder / "errors.csv", std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  fs::remove_all(folder);
  return text.str();
}

void expect_same_bits_again(const std::string& scene, const std::string& more = "") {
  const std::string first = errors_of_run(scene, 1, more);
  EXPECT_GT(lines_of(first).size(), 3u) << first;
  EXPECT_EQ(first, errors_of_run(scene, 2, more));
}

TEST(LongThreads, CpdiRunsTwiceToTheSameBits) { expect_same_bits_again("configs/paper/vortex_cpdi.yaml"); }

// Several tiles of particles: each thread adds to a copy of the grid.
TEST(LongThreads, ManyTilesRunTwiceToTheSameBits) {
  expect_same_bits_again("configs/paper/vortex_cpdi.yaml", " --set grid.spacing=0.025 --set time.end=0.01");
}

TEST(LongThreads, UgimpRunsTwiceToTheSameBits) { expect_same_bits_again("configs/paper/vortex_ugimp.yaml"); }

}  // namespace
}  // namespace assay::test_threads
