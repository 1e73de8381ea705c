// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/foreign/foreign_library.hpp"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "adapters/library.hpp"
#include "tests/adapters/foreign/foreign_doubles.hpp"
#include "tests/support/built.hpp"

namespace assay::adapters::test_foreign_library {
namespace {

TEST(ForeignLibrary, TellsASymbolThatNobodyHas) {
  // A file of its own: what was loaded once stays, and another test loads the plug-in as a native one.
  const std::string copy = testing::TempDir() + "unresolved_foreign_library.so";
  std::filesystem::copy_file(built("tests/plugins/unresolved.so"), copy,
                             std::filesystem::copy_options::overwrite_existing);
  const LoadedLibrary library = load_foreign_library(copy);
  std::filesystem::remove(copy);
  ASSERT_NE(library.handle, nullptr);
  EXPECT_EQ(library.missing, std::vector<std::string>{"assay_test_provided_by_nobody"});
}

TEST(ForeignLibrary, MissesNothingWhereAllIsThere) {
  const LoadedLibrary library = load_foreign_library(double_library("mfront_norton"));
  EXPECT_TRUE(library.missing.empty());
  EXPECT_NE(dlsym(library.handle, "Norton_Tridimensional"), nullptr);
  EXPECT_EQ(dlsym(RTLD_DEFAULT, "Norton_Tridimensional"), nullptr) << "its symbols are its own";
}

TEST(ForeignLibrary, OfWhatIsNoneIsRefused) {
  for (const char* path : {"/no/such/library.so", "/tmp", "/etc/passwd"}) {
    EXPECT_THROW(load_foreign_library(path), LibraryError) << path;
  }
}

}  // namespace
}  // namespace assay::adapters::test_foreign_library
