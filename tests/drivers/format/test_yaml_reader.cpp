// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/format/yaml_reader.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "drivers/system/input_file.hpp"
#include "tests/drivers/refusal.hpp"

namespace assay::drivers::test_yaml_reader {
namespace {

std::string refused(const std::string& text, const YamlLimits& limits = {}) {
  return refusal_of([&] { read_yaml(text, "f", limits); });
}

TEST(YamlReader, KeepsOrderPlaceAndQuoting) {
  const Tree root = read_yaml("b: 1\na: {x: [2, '3'], y: ~}\n", "f");
  ASSERT_EQ(root.entries.size(), 2u);
  EXPECT_EQ(root.entries[0].key, "b");
  const Tree& x = *root.find("a")->find("x");
  EXPECT_EQ(x.where.text(), "f:2:8");
  EXPECT_EQ(root.entries[1].key_where.text(), "f:2:1");
  EXPECT_FALSE(x.items[0].quoted);
  EXPECT_TRUE(x.items[1].quoted);
  EXPECT_EQ(root.find("a")->find("y")->kind, Tree::Kind::null);
  EXPECT_EQ(root.find("c"), nullptr);
}

TEST(YamlReader, RefusesDuplicateKeysAtAnyDepth) {
  EXPECT_EQ(refused("a: 1\nb: 2\na: 3\n"), "f:3:1: a: duplicate key");
  EXPECT_EQ(refused("x:\n  - {a: 1, b: {c: 1, 'c': 2}}\n"), "f:2:22: x[0].b.c: duplicate key");
}

TEST(YamlReader, TakesExactlyOneDocument) {
  EXPECT_EQ(refused(""), "f: empty");
  EXPECT_EQ(refused("# only a comment\n"), "f: empty");
  EXPECT_EQ(refused("---\na: 1\n---\nb: 1\n"), "f:3:1: a second document; one file holds one");
  EXPECT_EQ(refused("--- \na: 1\n...\n"), "accepted");
  EXPECT_NE(refused("a: 1\n---\n"), "accepted");
}

TEST(YamlReader, RefusesWhatIsAmbiguous) {
  EXPECT_EQ(refused("? [a]\n: 1\n"), "f:1:3: a key must be a word");
  EXPECT_EQ(refused("a: {{ b }}\n"), "f:1:5: a key must be a word: a text with braces belongs in quotes");
  EXPECT_EQ(refused("~: 1\n"), "f:1:1: a key must be a word");
  EXPECT_EQ(refused("a: !!str 1\n"), "f:1:4: a tag ('tag:yaml.org,2002:str'); tags have no meaning here");
  EXPECT_EQ(refused("a: !x {b: 1}\n"), "f:1:4: a tag ('!x'); tags have no meaning here");
  EXPECT_EQ(refused("a:\n\tb: 1\n"), "f:2:1: a tab in the indentation; YAML needs spaces");
  EXPECT_EQ(refused("a:\n \t b: 1\n"), "f:2:2: a tab in the indentation; YAML needs spaces");
  EXPECT_EQ(refused("a: 1\nb:\t2\t# remark\n"), "accepted");
}

TEST(YamlReader, RefusesBadText) {
  for (const char* bytes :
       {"\xff", "\xc3", "\xc0\x80", "\xe0\x80\x80", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xf8", "\x80"}) {
    EXPECT_EQ(refused("a: 1\nb: " + std::string(bytes) + "\n"), "f:2:4: not UTF-8 text");
  }
  EXPECT_EQ(refused(std::string("a: \0", 4)),
            "f:1:4: a control character, <U+0000>; not a text file?; holds U+0000, control character, which cannot be "
            "seen: delete it");
  EXPECT_NE(
      refused("a: \x1b[31m\n").find("f:1:4: a control character, <U+001B>; not a text file?; holds U+001B, escape"),
      std::string::npos);
  EXPECT_EQ(refused("\xff\xfe"
                    "a"),
            "f:1:1: UTF-16 text: save it as UTF-8");
  EXPECT_EQ(refused(std::string("a\0:\0 \0", 6)), "f:1:1: UTF-16 text: save it as UTF-8");
  EXPECT_EQ(read_yaml("\xef\xbb\xbf"
                      "a: \xc3\xa9\xe2\x82\xac\xf0\x9f\x98\x80\r\n",
                      "f")
                .find("a")
                ->text,
            "\xc3\xa9\xe2\x82\xac\xf0\x9f\x98\x80");
}

TEST(YamlReader, ACarriageReturnEndsALine) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    const Tree root = read_yaml("a: 1" + end + "b: {c: 2}" + end + end + "d: [3]" + end, "f.yaml");
    ASSERT_EQ(root.entries.size(), 3u);
    EXPECT_EQ(root.entries[2].key_where.line, 4);
    EXPECT_EQ(root.entries[1].value.find("c")->text, "2");
  }
}

TEST(YamlReader, SyntaxErrorsAreOneLineWithAPlace) {
  for (const char* text : {"a: [1, 2", "a: {b: 1", "a: b: c", "a: 'x", "- a\nb: 1", "a: *nowhere",
                           "%YAML 9.9\n---\na: 1", "a: \"\\q\"", "]", "@", "a: |x\n"}) {
    const std::string line = refused(text);
    EXPECT_TRUE(line.starts_with("f:")) << line;
    EXPECT_NE(line.find("not valid YAML: "), std::string::npos) << text << " -> " << line;
    EXPECT_EQ(line.find('\n'), std::string::npos);
  }
}

TEST(YamlReader, AKeyOfTooManyCharactersIsNamed) {
  for (const std::size_t length : {1100, 5000}) {
    const std::string key(length, 'k');
    EXPECT_EQ(refusal_of([&] { read_yaml("a: 1\n" + key + ": 1\n", "f"); }),
              "f:2:1: not valid YAML: a key of more than 1024 characters");
  }
  EXPECT_EQ(refusal_of([&] { read_yaml(std::string(1000, 'k') + ": 1\n", "f"); }), "accepted");
}

/// A later quote may close what was left open, and the parser does not mind the keys between.
TEST(YamlReader, AQuoteSwallowsNoKeys) {
  const std::string keys = "a: 1\nexpect:\n  outcome: failed\n", fault = "not valid YAML: a quote that is not closed";
  const auto swallows = [&](int line) {
    return fault + " in its line: line " + std::to_string(line) +
           " would be part of the text; lines of a text are indented deeper than its key";
  };
  for (const char* quote : {"'", "\""}) {
    const std::string open = std::string("title: ") + quote + "Small\n", close = quote;
    EXPECT_EQ(refused(open + keys), "f:1:8: " + fault);
    EXPECT_EQ(refused("b: 1\n" + open + keys + close + "\n"), "f:2:8: " + swallows(3));
    EXPECT_EQ(refused("b: 1\n" + open + keys + "# a comment" + close + "\n"), "f:2:8: " + swallows(3));
    EXPECT_EQ(refused("\xef\xbb\xbf" + open + keys + close), "f:1:8: " + swallows(2)) << "a byte order mark";
    EXPECT_EQ(refused("title: &name " + close + "Small\n" + keys), "f:1:14: " + fault) << "an anchor";
    EXPECT_EQ(refused("\xc3\xbc: 1\r\n" + open + "a: 1\r\n" + close + "\r\n"), "f:2:8: " + swallows(3));
    EXPECT_EQ(refused("m:\n  " + open + "  a: 1\n  b: 2" + close + "\n"), "f:2:10: " + swallows(3)) << "nested";
    EXPECT_EQ(refused("m:\n  - " + open + "    a: 1" + close + "\n"), "f:2:12: " + swallows(3)) << "in a list";
    EXPECT_EQ(refused("m:\n  - " + close + "x\n  - y" + close + "\n"), "f:2:5: " + swallows(3)) << "items";
    EXPECT_EQ(refused("m: {a: " + close + "x,\n    b: 1}\nc: 2" + close + "}\n"), "f:1:8: " + swallows(3)) << "braces";
    EXPECT_EQ(refused(close + "b: 1\n" + keys + close + ": 2\n").substr(0, 7), "f:1:1: ") << "before a key";
  }
}

TEST(YamlReader, ATextInQuotesMayHaveSeveralLines) {
  const auto text = [](const std::string& yaml) { return read_yaml(yaml, "f").entries.at(0).value.text; };
  EXPECT_EQ(text("t: 'One\n  note: two\n\n  - three'\nb: 1\n"), "One note: two\n- three");
  EXPECT_EQ(text("t: \"One: \\\n  two: three\"\nb: 1\n"), "One: two: three");
  EXPECT_EQ(text("t:\n  'One\n  note: two'\nb: 1\n"), "One note: two") << "below its key";
  EXPECT_EQ(text("t: 'One\nand two'\nb: 1\n"), "One and two") << "no key";
  EXPECT_EQ(text("t: 'Two ''quotes'''\nb: 'it''s'\n"), "Two 'quotes'");
  EXPECT_EQ(read_yaml("t:\n- 'One\n  note: two'\n", "f").entries.at(0).value.items.at(0).text, "One note: two");
}

TEST(LongYamlReader, DepthIsGuardedBeforeTheParserRecurses) {
  EXPECT_EQ(refused(std::string(64, '[') + std::string(64, ']')), "accepted");
  const std::string deep = "nested deeper than 64 levels";
  const auto cut = [&](const std::string& text) { return refused(text).ends_with(deep); };
  EXPECT_TRUE(cut(std::string(2000, '[')));
  EXPECT_EQ(refused(std::string(2000, '[') + std::string(2000, ']')), "f:1:65: " + deep);
  EXPECT_TRUE(cut(std::string(1000000, '[')));
  EXPECT_TRUE(cut(std::string(1000000, '{')));
  std::string dashes, maps;
  for (int i = 0; i < 100000; ++i) dashes += "- ";
  for (int i = 0; i < 1000; ++i) maps += std::string(static_cast<std::size_t>(i), ' ') + "a:\n";
  EXPECT_TRUE(cut(dashes)) << refused(dashes);
  EXPECT_TRUE(cut(maps)) << refused(maps);
  std::string questions;
  for (int i = 0; i < 5000; ++i) questions += "? ";
  EXPECT_NE(refused(questions), "accepted");
}

TEST(YamlReader, AliasesAreExpandedWithinLimits) {
  const Tree root = read_yaml("a: &x {k: [1, 2]}\nb: *x\n", "f");
  EXPECT_EQ(root.find("b")->find("k")->items[1].text, "2");
  EXPECT_EQ(refused("a: &a [*a]\n"), "f:1:8: an alias inside the value that it stands for");
  EXPECT_EQ(refused("&a {b: {c: *a}}\n"), "f:1:12: an alias inside the value that it stands for");
  std::string bomb = "a0: &a0 [x, x, x, x, x, x, x, x, x]\n";
  for (int i = 1; i < 12; ++i) {
    const std::string name = "a" + std::to_string(i), last = "*a" + std::to_string(i - 1);
    bomb += name + ": &" + name + " [" + last;
    for (int k = 0; k < 8; ++k) bomb += ", " + last;
    bomb += "]\n";
  }
  EXPECT_NE(refused(bomb).find("more than 100000 values"), std::string::npos) << refused(bomb);
}

TEST(YamlReader, MergeKeysBringWhatAMapLacks) {
  const Tree root = read_yaml(
      "x-steel: &steel {E: 1, nu: 2}\nx-soft: &soft {E: 3, rho: 4}\n"
      "a: {<<: *steel, nu: 5}\nb: {<<: [*soft, *steel]}\nc:\n  <<: {k: 6}\n  <: 7\n",
      "f");
  EXPECT_EQ(root.find("x-steel"), nullptr) << "it holds anchors";
  const auto text = [&](const char* map, const char* key) { return root.find(map)->find(key)->text; };
  EXPECT_EQ(text("a", "E") + text("a", "nu"), "15") << "its own key stays";
  EXPECT_EQ(text("b", "E") + text("b", "nu") + text("b", "rho"), "324") << "the first one counts";
  EXPECT_EQ(text("c", "k") + text("c", "<"), "67");
  EXPECT_EQ(root.find("a")->find("E")->where.text(), "f:1:21") << "where it is written";
  EXPECT_EQ(root.find("a")->entries.size(), 2u);
  EXPECT_EQ(refused("a: {<<: 1}\n"), "f:1:9: <<: takes a map, as *name of one with &name, or a list of maps");
  EXPECT_EQ(refused("a: {<<: [{b: 1}, c]}\n"),
            "f:1:18: <<: takes a map, as *name of one with &name, or a list of maps");
  EXPECT_EQ(refused("a: {<<: {b: 1}, <<: {c: 1}}\n"),
            "f:1:17: a.<<: duplicate key: several maps are merged by <<: [*a, *b]");
  EXPECT_EQ(read_yaml("a: {'<<': 1}\n", "f").find("a")->entries[0].key, "<<") << "in quotes it is a key as any";
  EXPECT_EQ(read_yaml("x-a: 1\n", set_option).entries.size(), 1u) << "of a whole file alone";
}

TEST(YamlReader, BracketsInATextOfAFlowMapAreTold) {
  const std::string told = "not valid YAML: a text with brackets belongs in quotes here";
  EXPECT_EQ(refused("m: {a: ${H}/l.so, b: 1}\n"), "f:1:8: " + told);
  EXPECT_EQ(refused("m: {a: ${r}}\n"), "f:1:8: " + told);
  EXPECT_EQ(refused("m: {a: 1[Pa], b: 1}\n"), "f:1:8: " + told);
  EXPECT_EQ(refused("m: {a: 1 {Pa}, b: 1}\n"), "f:1:10: " + told);
  EXPECT_NE(refused("m: {a: 1, b: 2} extra\n").find("text behind a closing quote or bracket"), std::string::npos);
}

TEST(YamlReader, WhatLooksLikeAMarkIsNamedWhereTheParserStops) {
  const auto ends = [](const std::string& text, const std::string& words) {
    EXPECT_TRUE(refused(text).ends_with(words)) << refused(text);
  };
  ends("g: \uFF5Bs: 1\uFF5D\n", "; U+FF5B stands where '{' belongs");
  ends("t: a\u0085m: 1: 2\n", "; the line holds U+0085, control character, which cannot be seen: delete it");
  ends("a: [1, 2\uFF3D\nb: 1\n", "a bracket '[' that is not closed");
  ends("t: \u041C: 1\n", "keys in braces");
}

TEST(YamlReader, SlipsOfAliasesAreToldWhereTheyStand) {
  const std::string anchors = "x-a: &A {E: 1}\nx-b: &B {nu: 2}\nx-l: &L [1, 2]\n";
  EXPECT_EQ(refused(anchors + "p: {<<: {*A, *B}}\n"),
            "f:4:10: a key must be a word, and here is an alias: maps are merged by <<: [*a, *b]");
  EXPECT_EQ(refused(anchors + "p: {<<: *L}\n"),
            "f:4:9: <<: takes a map, as *name of one with &name, or a list of maps");
  EXPECT_EQ(refused(anchors + "p:\n  <<: *A, *B\n"), "f:5:7: not valid YAML: several aliases are a list: [*a, *b]");
  EXPECT_EQ(refused(anchors + "p: {*A: 1}\n"), "f:4:7: not valid YAML: write a space between an alias and ':'");
  EXPECT_TRUE(read_yaml("b: &B {k: 1}\n", "f").find("b")->anchored);
}

TEST(YamlReader, MergedMapsCountTowardsTheLimits) {
  std::string bomb = "a0: &a0 {x: [1, 2, 3, 4, 5, 6, 7, 8, 9]}\n";
  for (int i = 1; i < 12; ++i) {
    const std::string last = "*a" + std::to_string(i - 1);
    bomb += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " {";
    for (int k = 0; k < 9; ++k) bomb += "k" + std::to_string(k) + ": {<<: " + last + "}, ";
    bomb += "l: 1}\n";
  }
  EXPECT_NE(refused(bomb).find("more than 100000 values"), std::string::npos) << refused(bomb);
}

TEST(YamlReader, CountsEveryValueOnce) {
  // map, key, anchored list of 3, key, alias of 4: 1 + 1 + 4 + 1 + 4
  const std::string text = "a: &x [1, 2, 3]\nb: *x\n";
  EXPECT_EQ(refused(text, {.values = 11}), "accepted");
  EXPECT_NE(refused(text, {.values = 10}), "accepted");
  EXPECT_EQ(refused("abc: 1", {.bytes = 5}), "f: longer than 5 bytes");
}

TEST(YamlReader, FilesThatCannotBeRead) {
  const std::string folder = testing::TempDir();
  EXPECT_EQ(refusal_of([&] { read_bytes(folder); }), folder + ": is a folder, not a file");
  EXPECT_EQ(refusal_of([&] { read_bytes(folder + "absent.yaml"); }),
            folder + "absent.yaml: cannot be read: No such file or directory");
  EXPECT_EQ(refusal_of([&] { read_bytes(""); }), "'' is not the name of a file");
  std::ofstream(folder + "bytes.yaml") << "a: 1\n";
  EXPECT_EQ(refusal_of([&] { read_bytes(folder + "bytes.yaml", 4); }), folder + "bytes.yaml: longer than 4 bytes");
  EXPECT_EQ(read_bytes(folder + "bytes.yaml"), "a: 1\n");
}

}  // namespace
}  // namespace assay::drivers::test_yaml_reader
