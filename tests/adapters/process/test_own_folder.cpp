// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/process/private_files.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "adapters/process/kept_process.hpp"

namespace assay::adapters::test_own_folder {
namespace {

namespace fs = std::filesystem;

std::string here() { return fs::current_path().string(); }

TEST(OwnFolder, GoesWithWhatIsInIt) {
  std::string path;
  {
    const OwnFolder folder;
    path = folder.path();
    EXPECT_EQ(fs::path(path).parent_path(), temporary_folder());
    std::ofstream(path + "/file") << "text";
  }
  EXPECT_FALSE(fs::exists(path));
}

TEST(OwnFolder, IsWhereForeignCodeRuns) {
  const std::string before = here();
  const Forked found = in_a_child([] {
    std::ofstream("data.csv") << "text";
    return here();
  });
  EXPECT_NE(found.text, before);
  EXPECT_FALSE(fs::exists(found.text)) << "with what was written in it";
  EXPECT_EQ(here(), before);
}

// Its folder may hold files of the model.
TEST(OwnFolder, AProcessThatStandsApartStays) {
  const Forked found = in_a_child([] {
    const Forked inner = in_a_child(here);
    return inner.text == here() ? std::string("the same") : inner.text;
  });
  EXPECT_EQ(found.text, "the same");
}

}  // namespace
}  // namespace assay::adapters::test_own_folder
