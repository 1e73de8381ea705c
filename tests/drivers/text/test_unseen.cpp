// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/text/unseen.hpp"

#include <gtest/gtest.h>

#include "drivers/scene/scene_reader.hpp"
#include "drivers/system/input_error.hpp"
#include "tests/drivers/refusal.hpp"
#include "tests/drivers/scene_text.hpp"

namespace assay::drivers::test_unseen {
namespace {

std::string refused(const std::string& extra) {
  return refusal_of([&] { scene_from_text(scene_text(extra), "f.yaml"); });
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(Unseen, IsWrittenAndNamedInAValue) {
  const std::vector<std::pair<std::string, std::string>> unseen{
      {"\u200B", "U+200B, zero width space, which cannot be seen: delete it"},
      {"\u2060", "U+2060, word joiner, which cannot be seen: delete it"},
      {"\uFEFF", "U+FEFF, byte order mark, which cannot be seen: delete it"},
      {"\u00AD", "U+00AD, soft hyphen, which cannot be seen: delete it"},
      {"\u202E", "U+202E, mark of the direction of writing, which cannot be seen: delete it"},
      {"\u00A0", "U+00A0, no-break space, which cannot be seen: write a blank in its place"},
      {"\u2009", "U+2009, thin space, which cannot be seen: write a blank in its place"}};
  for (const auto& [character, name] : unseen) {
    const std::string line = refused("grid: {spacing: 1}\nmethod: {basis: cpdi" + character + "}\n");
    EXPECT_TRUE(has(line, "f.yaml:4:17: method.basis: unknown value 'cpdi<" + name.substr(0, 6) + ">' (nearest: cpdi)"))
        << line;
    EXPECT_TRUE(has(line, "; holds " + name + "; known: linear")) << line;
  }
}

TEST(Unseen, IsWrittenAndNamedInAKey) {
  EXPECT_EQ(refused("grid: {spacing\u00A0: 0.1}\n"),
            "f.yaml:3:8: grid.spacing<U+00A0>: unknown key (nearest: spacing); holds U+00A0, no-break space, which "
            "cannot be seen: write a blank in its place; known: spacing, offset, lower, upper");
  EXPECT_TRUE(has(refused("grid: {spacing:\u00A00.1}\n"), "grid.spacing:<U+00A0>0.1: unknown key"));
  EXPECT_TRUE(has(refused("grid: {\"spac\\aing\": 0.1}\n"), "grid.spac<U+0007>ing: unknown key (nearest: spacing)"));
  EXPECT_TRUE(has(refused("grid: {\"spac\\ning\": 0.1}\n"), "holds U+000A, line break"));
}

TEST(Unseen, IsWrittenAndNamedInANumberAndATitle) {
  EXPECT_TRUE(has(refused("grid: {spacing: 0.1\u200B}\n"), "found '0.1<U+200B>'; holds U+200B, zero width space"));
  EXPECT_TRUE(has(refused("title: \"a\\x1b[31mb\"\n"), "title: must be one line of text, found 'a<U+001B>[31mb'"));
  EXPECT_TRUE(has(refused("title: |\n  two\n  lines\n"), "found 'two<U+000A>lines'; holds U+000A, line break"));
  EXPECT_EQ(refused("title: >\n  folded\n"), "accepted") << "the line break at the end is the block's";
  EXPECT_EQ(refused("title: |\n  kept\n"), "accepted");
  EXPECT_EQ(refused("title: d\u00E9j\u00E0\u00A0vu \u200D\n"), "accepted") << "letters, and what joins them";
}

/// U+FFFE and U+FFFF are never characters, and no XML may hold them.
TEST(Unseen, WhatIsNoCharacterReachesNoPage) {
  for (const char* text : {"a\xEF\xBF\xBE", "a\xEF\xBF\xBF", "a\xF0\x9F\xBF\xBE"}) {
    for (const std::string& written : {printable(text), utf8(text), with_unseen_written(text)}) {
      EXPECT_TRUE(written.starts_with("a?")) << written;
      EXPECT_EQ(written.find('\xBF'), std::string::npos);
    }
  }
  EXPECT_EQ(utf8("a\xEF\xBF\xBD"), "a\xEF\xBF\xBD");
  EXPECT_TRUE(has(refused("title: \"a\\uFFFEb\"\n"), "holds U+FFFE, which is no character: delete it"));
  EXPECT_TRUE(has(refused("title: \"a\\uFFFFb\"\n"), "holds U+FFFF, which is no character: delete it"));
}

TEST(Unseen, LookalikesAreNamed) {
  EXPECT_TRUE(has(refused("grid: {spacing: \u22120.1}\n"), "found '\u22120.1': U+2212 stands where '-' belongs"));
  EXPECT_TRUE(has(refused("grid: {spacing: \u201C0.1\u201D}\n"), "U+201C stands where '\"' belongs"));
  EXPECT_TRUE(has(refused("method: {basis: \u0441pdi}\n"), "U+0441 stands where 'c' belongs"));
  EXPECT_TRUE(has(refused("grid: {spacing: \uFF10.1}\n"), "U+FF10 stands where '0' belongs"));
  EXPECT_TRUE(has(refused("grid: {spacing: 0\uFF0E1}\n"), "U+FF0E stands where '.' belongs"));
  EXPECT_TRUE(has(refused("grid: {spacing: \u0663}\n"), "U+0663 stands where '3' belongs"));
  EXPECT_EQ(lookalike("plain -'\":,"), "");
}

TEST(Unseen, ANameThatLooksLikeAKnownOneIsThatOne) {
  const std::vector<std::string> columns{"X", "Y", "t"};
  EXPECT_EQ(nearest_words("\u03A7", columns), " (nearest: X), U+03A7 stands where 'X' belongs");
  EXPECT_EQ(nearest_words("\u0425", columns), " (nearest: X), U+0425 stands where 'X' belongs");
  EXPECT_EQ(nearest_words("\U0001D44C", columns), " (nearest: Y), U+1D44C stands where 'Y' belongs") << "of a formula";
  EXPECT_EQ(nearest_words("\uFF54", columns), " (nearest: t), U+FF54 stands where 't' belongs");
  EXPECT_EQ(nearest_words("l2\u2011max", {"l2_max"}), " (nearest: l2_max), U+2011 stands where '_' belongs");
  EXPECT_EQ(nearest_words("\u2014set", {"--set"}), " (nearest: --set), U+2014 stands where '-' belongs");
  EXPECT_EQ(as_meant("\U0001D7CF\u096A\u2082\uFF15"), "1425");
}

TEST(Unseen, LinesForATerminalKeepTheirLayoutAlone) {
  EXPECT_EQ(without_commands("a\tb\n\x1b[31mc\u009Bd\u202Ee\xFF", "<U+", ">"),
            "a\tb\n<U+001B>[31mc<U+009B>d<U+202E>e?");
  EXPECT_EQ(without_commands("\"\u009B\"", "\\u", ""), "\"\\u009B\"");
  EXPECT_EQ(printable("a\tb\nc\x1b\u00A0"), "a b c<U+001B>\u00A0");
  EXPECT_EQ(shown("a\tb\u00A0", 80), "a<U+0009>b<U+00A0>");
  EXPECT_EQ(shown("abcdef", 3), "abc...");
}

TEST(Unseen, KnownWordsBeyondFortyAreTheNearest) {
  std::vector<std::string> words;
  for (int i = 0; i < 40; ++i) words.push_back("word" + std::to_string(i));
  EXPECT_EQ(known_words("word7", words), joined(words));
  words.emplace_back("error.l2_max");
  EXPECT_EQ(known_words("error.l2", words, "X"), "error.l2_max, " + known_words("error.l2", words, "X").substr(14))
      << known_words("error.l2", words, "X");
  EXPECT_TRUE(known_words("error.l2", words, "X").ends_with(" and 35 more, which X lists"));
}

}  // namespace
}  // namespace assay::drivers::test_unseen
