// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/system/input_error.hpp"

#include <gtest/gtest.h>

namespace assay::drivers::test_input_error {
namespace {

TEST(InputError, SaysWhereWhatAndWhatIsKnown) {
  EXPECT_STREQ(InputError({"a.yaml", 3, 7}, "grid.h", "unknown key", "spacing").what(),
               "a.yaml:3:7: grid.h: unknown key; known: spacing");
  EXPECT_STREQ(InputError({"a.yaml", 3, 0}, "", "empty").what(), "a.yaml:3: empty");
  EXPECT_STREQ(InputError({"a.yaml", 0, 5}, "k", "no").what(), "a.yaml: k: no");
  EXPECT_STREQ(InputError({set_option, 0, 0}, "grid.h", "no").what(), "--set grid.h: no");
  EXPECT_STREQ(InputError({set_option, 0, 0}, "", "no").what(), "--set: no");
  EXPECT_STREQ(InputError({}, "", "no").what(), "no");
}

TEST(InputError, IsAlwaysOneLine) {
  EXPECT_STREQ(InputError({"a\nb", 1, 1}, "k\r", "x\ty\x7f").what(),
               "a b:1:1: k : x y<U+007F>; holds U+007F, control character, which cannot be seen: delete it");
  EXPECT_STREQ(InputError("one\ntwo").what(), "one two");
  EXPECT_LE(std::string(InputError({"a", 1, 1}, "k", std::string(100000, 'x')).what()).size(), 4200u);
}

TEST(InputError, CutsBetweenCharacters) {
  EXPECT_EQ(one_line("abcdef", 4), "abcd...");
  EXPECT_EQ(one_line("abc\xC3\xA9", 4), "abc...");
  EXPECT_EQ(one_line("ab\xE2\x82\xAC!", 4), "ab...");
  EXPECT_EQ(one_line("abcd", 4), "abcd");
  EXPECT_EQ(one_line("a\xC2\x9B"
                     "b\xE2\x80\xAE"
                     "c\xE2\x80\xA8"
                     "d\x1B[e"),
            "a<U+009B>b<U+202E>c<U+2028>d<U+001B>[e");  // C1, bidi, line separator, ESC
  EXPECT_EQ(one_line("\xFF"
                     "a\xC3"),
            "?a?");
  EXPECT_EQ(one_line("\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80"), "\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80");
}

TEST(InputError, SuggestsTheNearestWord) {
  const std::vector<std::string> known{"inner", "outer", "period", "profile_power"};
  EXPECT_EQ(nearest("iner", known), "inner");
  EXPECT_EQ(nearest("innre", known), "inner");
  EXPECT_EQ(nearest("profile_pwoer", known), "profile_power");
  EXPECT_EQ(nearest("profile", known), "profile_power") << "the beginning of a word";
  EXPECT_EQ(nearest("INNER", known), "inner");
  EXPECT_EQ(nearest("OUTTER", known), "outer");
  EXPECT_EQ(nearest("x", {"y", "X"}), "X");
  EXPECT_EQ(nearest("x", {"y"}), "") << "all letters are one apart";
  EXPECT_EQ(nearest("temperature", known), "");
  EXPECT_EQ(nearest("", known), "");
  EXPECT_EQ(nearest("inner", {}), "");
  EXPECT_EQ(unknown("key", "iner", known), "unknown key (nearest: inner)");
  EXPECT_EQ(unknown("key", "qqq", known), "unknown key");
}

}  // namespace
}  // namespace assay::drivers::test_input_error
