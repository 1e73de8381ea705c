// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/scene/scene_reader.hpp"

#include <gtest/gtest.h>

#include "tests/drivers/refusal.hpp"

namespace assay::drivers::test_settings {
namespace {

Tree changed(const std::string& text, const std::string& setting) {
  Tree root = read_yaml(text, "f");
  apply_setting(root, parse_setting(setting));
  return root;
}

std::string refused(const std::string& setting) {
  return refusal_of([&] { changed("a: {b: 1}\nlist: [1]\n", setting); });
}

TEST(Settings, ReplaceAddAndMakeMaps) {
  EXPECT_EQ(changed("a: {b: 1, c: 2}", "a.b=3").find("a")->find("b")->text, "3");
  EXPECT_EQ(changed("a: {b: 1, c: 2}", "a.b=3").find("a")->find("c")->text, "2");
  EXPECT_EQ(changed("a: {b: 1, c: 2}", "a={d: 3}").find("a")->find("b"), nullptr) << "a map replaces a map";
  EXPECT_EQ(changed("a: {b: 1}", "a={}").find("a")->entries.size(), 0u);
  EXPECT_EQ(changed("a: 1", "x.y.z=[1, 2]").find("x")->find("y")->find("z")->items.size(), 2u);
  EXPECT_EQ(changed("a:", "a.b=1").find("a")->find("b")->text, "1") << "an empty section";
  EXPECT_EQ(changed("a: 1", "t=x = y").find("t")->text, "x = y") << "only the first '=' counts";
  EXPECT_EQ(changed("a: 1", "a='5'").find("a")->quoted, true);
}

TEST(Settings, KeysAreJoinedByDots) {
  for (const char* joined : {"grid:spacing", "grid: spacing", "grid/spacing", "grid[spacing]", "grid::spacing"}) {
    EXPECT_EQ(refused(joined + std::string("=.1")),
              "--set " + std::string(joined) + ": keys are joined by '.': write grid.spacing=...");
  }
  EXPECT_EQ(changed("a: {b: 1}", " a.b =3").find("a")->find("b")->text, "3") << "blanks beside '='";
  EXPECT_EQ(changed("a: {b: 1}", "a.b=c:/d").find("a")->find("b")->text, "c:/d") << "a value";
  EXPECT_EQ(refused("title=a #b"), "--set title: ' #' begins a comment of YAML: a text with it belongs in quotes");
  for (const char first : std::string("@`%*&!")) {
    const std::string begins(1, first);
    EXPECT_EQ(refused("title=" + begins + "d"),
              "--set title: a value that begins with '" + begins + "' belongs in quotes");
  }
  EXPECT_EQ(changed("a: 1", "a='b #c'").find("a")->text, "b #c");
}

TEST(Settings, ReplaceAValueOfAList) {
  const Tree changed_list = changed("a: {b: [1, 2, 3]}", "a.b.2=7");
  EXPECT_EQ(changed_list.find("a")->find("b")->items[2].text, "7");
  EXPECT_EQ(changed_list.find("a")->find("b")->items[0].text, "1");
  EXPECT_EQ(changed("a: [{b: 1}]", "a.0.b=2").find("a")->items[0].find("b")->text, "2");
  EXPECT_EQ(changed("a: [{b: 1}]", "a[0].b=2").find("a")->items[0].find("b")->text, "2");
  EXPECT_EQ(changed("a: [[1, 2]]", "a[0][1]=3").find("a")->items[0].items[1].text, "3");
  EXPECT_EQ(refused("list[1]=1"), "--set list[1]: 'list' is a list of 1, counted from 0");
  EXPECT_EQ(refused("list[01]=1"), "--set list[01]: keys are joined by '.': write list.01=...");
  EXPECT_EQ(refused("list[0]x=1"), "--set list[0]x: keys are joined by '.': write list.0.x=...");
  EXPECT_EQ(refused("a[-1].b=1"), "--set a[-1].b: keys are joined by '.': write a.-1.b=...");
  EXPECT_EQ(refused("[0]=1"), "--set: takes key.path=value, found '[0]=1'");
  for (const char* index : {"x", "1", "-1", "0x0", "00", "18446744073709551616", "1e0"}) {
    EXPECT_EQ(refused(std::string("list.") + index + "=1"),
              std::string("--set list.") + index + ": 'list' is a list of 1, counted from 0");
  }
}

TEST(Settings, AListThatIsNotThereHasNoValues) {
  EXPECT_EQ(refused("grid.offset.1=0.5"),
            "--set grid.offset.1: the scene has no list 'grid.offset' of which to set a value");
  EXPECT_EQ(changed("a: {b: 1}", "a.1=2").find("a")->find("1")->text, "2") << "a map's key";
}

TEST(Settings, NumbersInBracketsAreStepsOfAPath) {
  EXPECT_EQ(dotted("motion.vortices[10].center[2]"), "motion.vortices.10.center.2");
  for (const char* path :
       {"grid.spacing", "a[b]", "a[1", "a]1[", "a[]", "a[-1]", "a[1]b", "expect.a[0]", "material.parameters.C[0]"}) {
    EXPECT_EQ(dotted(path), path);
  }
}

TEST(Settings, WhatFollowsExpectIsOneKey) {
  const std::string text = "expect: {error.l2_max: {below: 1}}";
  EXPECT_EQ(changed(text, "expect={}").find("expect")->entries.size(), 0u);
  const Tree replaced = changed(text, "expect.error.l2_max={above: 2}");
  EXPECT_EQ(replaced.find("expect")->entries.size(), 1u);
  EXPECT_EQ(replaced.find("expect")->find("error.l2_max")->find("above")->text, "2");
  EXPECT_EQ(changed(text, "expect.error.l2_max.below=2").find("expect")->find("error.l2_max")->find("below")->text,
            "2");
  EXPECT_EQ(changed(text, "expect.outcome=unstable").find("expect")->find("outcome")->text, "unstable");
}

TEST(Settings, RefuseWhatIsNoSetting) {
  EXPECT_EQ(refused("a.b"), "--set: takes key.path=value, found 'a.b'");
  EXPECT_EQ(refused("=1"), "--set: takes key.path=value, found '=1'");
  EXPECT_EQ(refused("a..b=1"), "--set: takes key.path=value, found 'a..b=1'");
  EXPECT_EQ(refused(""), "--set: takes key.path=value, found ''");
  EXPECT_EQ(refused("a.b="), "--set a.b: no value after '='");
  EXPECT_EQ(refused("a.b.c=1"), "--set a.b.c: 'a.b' is not a map");
  EXPECT_TRUE(refused("a={b: 1").starts_with("--set a: not valid YAML: "));
  EXPECT_EQ(refused("a={b: 1, b: 2}"), "--set a: b: duplicate key");
  EXPECT_EQ(refused("a=" + std::string(2000, '[')), "--set a: nested deeper than 64 levels");
  std::string deep = "a";
  for (int i = 0; i < 5000; ++i) deep += ".a";
  EXPECT_TRUE(refused(deep + "=1").ends_with("nested too deep"));
}

}  // namespace
}  // namespace assay::drivers::test_settings
