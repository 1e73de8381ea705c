// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/foreign/foreign_library.hpp"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include "adapters/library.hpp"
#include "tests/adapters/foreign/foreign_doubles.hpp"
#include "tests/support/built.hpp"

namespace assay::adapters::test_foreign_library {
namespace {

TEST(ForeignLibrary, TellsASymbolThatNobodyHas) {
  const LoadedLibrary library = load_foreign_library(built("tests/plugins/unresolved.so"));
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
