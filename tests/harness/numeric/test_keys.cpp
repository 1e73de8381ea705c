// SPDX-License-Identifier: BSD-3-Clause
#include "harness/numeric/keys.hpp"

#include <gtest/gtest.h>

namespace assay::test_keys {
namespace {

struct Part {
  double radius = 0.5;
  int turns = 2;
  Vector3 center = Vector3::Zero();
  std::optional<double> width = {}, speed = {};

  void keys(auto& key) {
    key("radius", "radius [m]", radius, {.range = positive});
    key("turns", "number of turns", turns);
    key("center", "centre [m]", center);
    key("width", "width [m]", width);
    key("speed", "speed [m/s]", speed, {.automatic = true});
  }
};

struct Whole {
  std::vector<Part> parts;
  void keys(auto& key) { key("parts", "parts of the whole", parts, {.required = true}); }
};

/// What the struct shows of its one key.
struct Seen {
  KeyInfo key;
  KeyType type{};
  KeyValue value;
};
Seen seen_in(Whole whole, const std::optional<KeyValue>& answer = {}, Whole* after = nullptr) {
  Seen seen;
  EachKey look([&](const KeyInfo& key, KeyType type, const KeyValue& value) {
    seen = {key, type, value};
    return answer;
  });
  whole.keys(look);
  if (after) *after = whole;
  return seen;
}

TEST(Keys, AListOfPartsIsShownAsRecords) {
  const Part thin{.radius = 0.1, .width = 0.25};
  const Seen seen = seen_in({{Part(), thin}});
  EXPECT_EQ(seen.type, KeyType::list);
  EXPECT_TRUE(seen.key.required);
  const auto& records = std::get<std::vector<KeyRecord>>(seen.value);
  ASSERT_EQ(records.size(), 2u);
  EXPECT_EQ(*records[1].find("radius"), KeyValue(0.1));
  EXPECT_EQ(*records[1].find("turns"), KeyValue(2.0));
  EXPECT_EQ(*records[1].find("center"), KeyValue(std::vector{0.0, 0.0, 0.0}));
  EXPECT_EQ(*records[1].find("width"), KeyValue(0.25));
  EXPECT_EQ(*records[1].find("speed"), KeyValue("auto"));
  EXPECT_EQ(records[0].find("width"), nullptr) << "absent";
  EXPECT_EQ(records[0].find("depth"), nullptr) << "no key";
  EXPECT_FALSE(records[0] == records[1]);
}

TEST(Keys, AListWithoutPartsIsAbsent) { EXPECT_EQ(seen_in({}).value, KeyValue()); }

TEST(Keys, AListTakesRecords) {
  KeyRecord record;
  record.values = {{"radius", 3.0}, {"center", std::vector{1.0, 2.0, 3.0}}, {"speed", 7.0}};
  Whole after;
  seen_in({}, std::vector{record, KeyRecord()}, &after);
  ASSERT_EQ(after.parts.size(), 2u);
  EXPECT_EQ(after.parts[0].radius, 3);
  EXPECT_EQ(after.parts[0].center, Vector3(1, 2, 3));
  EXPECT_EQ(after.parts[0].speed, 7);
  EXPECT_EQ(after.parts[0].turns, 2) << "its default";
  EXPECT_EQ(after.parts[1].radius, 0.5);
}

TEST(Keys, WhatAListShowsItTakes) {
  const KeyValue shown = seen_in({{Part(), {.turns = 3, .speed = 2}}}).value;
  Whole after;
  seen_in({}, shown, &after);
  EXPECT_EQ(seen_in(after).value, shown);
  EXPECT_EQ(after.parts[0].speed, std::nullopt) << "auto";
}

TEST(Keys, AListShowsTheKeysOfAnItem) {
  std::vector<std::string> names;
  EachKey look([&](const KeyInfo& key, KeyType, const KeyValue&) -> EachKey::Answer {
    names.emplace_back(key.name);
    return std::nullopt;
  });
  const Seen seen = seen_in({});
  ASSERT_NE(seen.key.item, nullptr);
  seen.key.item(look);
  EXPECT_EQ(names, (std::vector<std::string>{"radius", "turns", "center", "width", "speed"}));
}

}  // namespace
}  // namespace assay::test_keys
