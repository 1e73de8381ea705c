// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/text/words.hpp"

#include <gtest/gtest.h>

namespace assay::drivers::test_words {
namespace {

using Words = std::vector<std::string>;

TEST(Words, LettersOfAsciiAloneChangeTheirSize) {
  EXPECT_EQ(small_letters("Umat_É9"), "umat_É9");
  EXPECT_EQ(capital_letters("umat_é9"), "UMAT_é9");
  EXPECT_FALSE(is_letter("é"[0]));
  EXPECT_EQ(as_name("My-Clay 2"), "my_clay_2");
}

TEST(Words, EndsAreStrippedOfBlanksAlone) {
  EXPECT_EQ(stripped("\t a b \t"), "a b");
  EXPECT_EQ(stripped(" \t "), "");
  EXPECT_EQ(stripped(""), "");
  EXPECT_EQ(stripped(" a\r", " \t\r"), "a");
}

TEST(Words, ThereIsOnePartMoreThanSeparators) {
  EXPECT_EQ(split("", ','), Words{""});
  EXPECT_EQ(split("a", ','), Words{"a"});
  EXPECT_EQ(split(",a,,b,", ','), (Words{"", "a", "", "b", ""}));
}

TEST(Words, AWordHasItsPlaceInAList) {
  const Words words{"a", "b"};
  EXPECT_EQ(index_of("b", words), 1u);
  EXPECT_EQ(index_of("c", words), words.size());
  EXPECT_TRUE(is_one_of("a", words));
  EXPECT_FALSE(is_one_of("", words));
}

}  // namespace
}  // namespace assay::drivers::test_words
