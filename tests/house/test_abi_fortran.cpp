// SPDX-License-Identifier: BSD-3-Clause
// The Fortran module says what the C header says.
#include <gtest/gtest.h>

#include <array>
#include <regex>
#include <set>

#include "tests/house/abi_layout.h"
#include "tests/house/tree.hpp"

namespace assay::test_abi_fortran {
namespace {

using namespace assay::house;

TEST(AbiFortran, SizesOffsetsAndConstantsAreThoseOfTheHeader) {
#if !ASSAY_HAS_FORTRAN
  GTEST_SKIP() << "no Fortran compiler";
#else
  const abi_layout_entry* expected = nullptr;
  const int count = abi_layout_c(&expected);
  std::array<std::int64_t, 200> found{};
  ASSERT_EQ(abi_layout_fortran(static_cast<std::int32_t>(found.size()), found.data()), count);
  for (int i = 0; i < count; ++i) EXPECT_EQ(found[static_cast<std::size_t>(i)], expected[i].value) << expected[i].name;
#endif
}

/// The module, and the list of abi_layout.c, know every type and constant of the header.
TEST(AbiFortran, NothingOfTheHeaderIsLeftOut) {
  const std::string header = text_of("harness/assay_material.h"), fortran = text_of("harness/assay_material.f90"),
                    layout = text_of("tests/house/abi_layout.c");
  const std::regex name(R"(\b(ASSAY_[A-Z_]+|assay_[a-z_]+) *[=;]|#define (ASSAY_[A-Z_]+) )");
  const std::set<std::string> of_c_alone{"ASSAY_EXPORT", "ASSAY_ENTRY_SYMBOL", "ASSAY_MATERIAL_H"};
  int seen = 0;
  for (std::sregex_iterator it(header.begin(), header.end(), name), end; it != end; ++it) {
    const std::string word = (*it)[1].matched ? (*it)[1] : (*it)[2];
    if (of_c_alone.count(word)) continue;
    ++seen;
    EXPECT_TRUE(std::regex_search(fortran, std::regex("\\b" + word + "\\b", std::regex::icase))) << word;
    const bool id = word.starts_with("ASSAY_EXTENSION_");
    EXPECT_TRUE(id || std::regex_search(layout, std::regex("\\b" + word + "\\b"))) << word;
  }
  EXPECT_GT(seen, 35);
}

TEST(AbiFortran, ExtensionsHaveTheSameIds) {
  const std::string header = text_of("harness/assay_material.h"), fortran = text_of("harness/assay_material.f90");
  const std::regex id(R"re(#define (ASSAY_EXTENSION_[A-Z_]+) "([^"]+)")re");
  int seen = 0;
  for (std::sregex_iterator it(header.begin(), header.end(), id), end; it != end; ++it, ++seen) {
    const std::regex line((*it)[1].str() + " = '" + (*it)[2].str() + "'", std::regex::icase);
    EXPECT_TRUE(std::regex_search(fortran, line)) << (*it)[1];
  }
  EXPECT_EQ(seen, 8);
}

}  // namespace
}  // namespace assay::test_abi_fortran
