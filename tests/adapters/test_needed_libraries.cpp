// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/elf_symbols.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "tests/support/built.hpp"

namespace assay::adapters::test_needed_libraries {
namespace {

namespace fs = std::filesystem;
using Files = std::vector<std::string>;

TEST(NeededLibraries, AreThoseThatTheLibraryNames) {
  const std::string folder = built("tests/plugins/");
  EXPECT_EQ(with_needed_libraries(folder + "asks_a_helper.so"),
            (Files{folder + "asks_a_helper.so", folder + "libhelper.so"}))
      << "without those of the system";
  EXPECT_EQ(with_needed_libraries(folder + "libhelper.so"), (Files{folder + "libhelper.so"}));
}

/// $ORIGIN is where the library lies; then comes LD_LIBRARY_PATH; what is nowhere is left out.
TEST(NeededLibraries, AreSoughtAsTheLoaderDoes) {
  const fs::path scratch = fs::temp_directory_path() / ("assay-test-needed-" + std::to_string(::getpid()));
  const fs::path elsewhere = scratch / "elsewhere";
  const std::string library = (scratch / "asks_a_helper.so").string();
  fs::create_directories(elsewhere);
  fs::copy(built("tests/plugins/asks_a_helper.so"), library);
  EXPECT_EQ(with_needed_libraries(library), Files{library});
  fs::copy(built("tests/plugins/libhelper.so"), elsewhere / "libhelper.so");
  const char* const given = std::getenv("LD_LIBRARY_PATH");
  const std::string before = given ? given : "";
  ::setenv("LD_LIBRARY_PATH", ("/nowhere:" + elsewhere.string()).c_str(), 1);
  EXPECT_EQ(with_needed_libraries(library), (Files{library, (elsewhere / "libhelper.so").string()}));
  given ? ::setenv("LD_LIBRARY_PATH", before.c_str(), 1) : ::unsetenv("LD_LIBRARY_PATH");
  fs::copy(built("tests/plugins/libhelper.so"), scratch / "libhelper.so");
  EXPECT_EQ(with_needed_libraries(library), (Files{library, (scratch / "libhelper.so").string()}));
  fs::remove_all(scratch);
}

}  // namespace
}  // namespace assay::adapters::test_needed_libraries
