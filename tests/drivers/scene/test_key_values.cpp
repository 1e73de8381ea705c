// SPDX-License-Identifier: BSD-3-Clause
// A key whose member is a list of parts, of a struct that is in no scene.
#include "drivers/scene/key_values.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "drivers/scene/scene_reader.hpp"
#include "tests/drivers/json_schema.hpp"
#include "tests/drivers/refusal.hpp"

namespace assay::drivers::test_key_values {
namespace {

enum class Profile { ball, torus };
constexpr std::array<const char*, 2> names_of(Profile) { return {"ball", "torus"}; }

struct Whirl {
  Profile profile = Profile::ball;
  double strength = 0;
  int turns = 1;
  Vector3 centre = Vector3::Zero();
  std::optional<double> ring_width = {}, pace = {};
  bool held = false;
  std::string label = "x";
  Tensor stretch = Tensor::Identity();
  std::array<double, 2> span{0, 1};

  void keys(auto& key) {
    key("profile", "shape of the whirl", profile);
    key("strength", "strength [m]", strength, {.range = positive, .required = true});
    key("turns", "number of turns", turns, {.range = {.lower = 1, .upper = 9, .whole = true}});
    key("centre", "centre [m]", centre);
    key("ring_width", "width of a torus [m]", ring_width, {.range = positive, .derived = "none"});
    key("pace", "pace [m/s]", pace, {.automatic = true});
    key("held", "whether it is held", held);
    key("label", "text of the whirl", label, {.shown = label != "x"});
    key("stretch", "stretch [1]", stretch);
    key("span", "from and to [s]", span);
  }
};

struct Whirls {
  std::vector<Whirl> whirls;
  void keys(auto& key) { key("whirls", "several whirls in one body", whirls); }
};

/// The row of the key, as of a motion, and what it reads into.
class KeyValues : public testing::Test {
 protected:
  Tree value(const std::string& yaml) const { return *read_yaml("whirls:\n" + yaml, "f").find("whirls"); }
  void read(const std::string& yaml) { key.set(scene, read_value(key, value(yaml))); }
  std::string refused(const std::string& yaml) {
    return refusal_of([&] { read(yaml); });
  }
  std::string written() const { return "whirls:" + value_text(key, key.get(scene)) + "\n"; }

  Whirls all;
  const std::vector<Whirl>& whirls = all.whirls;
  Scene scene;
  const Key key = keys_of("motion", Whirls(), [this](auto&&) -> Whirls& { return all; }).front();
};

constexpr const char* known = "; known: profile, strength, turns, centre, ring_width, pace, held, label, stretch, span";

TEST_F(KeyValues, ItemsAreReadWithTheirDefaults) {
  read(
      "  - {profile: torus, strength: 0.4, centre: [0.5, 0, 1], ring_width: 2, pace: 3}\n"
      "  - strength: 0.25\n"
      "    pace: auto\n"
      "    held: true\n"
      "    stretch: [[1, 2, 3], [4, 5, 6], [7, 8, 9]]\n"
      "    span: [2, 3]\n");
  ASSERT_EQ(whirls.size(), 2u);
  EXPECT_EQ(whirls[0].profile, Profile::torus);
  EXPECT_EQ(whirls[0].strength, 0.4);
  EXPECT_EQ(whirls[0].centre, Vector3(0.5, 0, 1));
  EXPECT_EQ(whirls[0].ring_width, 2);
  EXPECT_EQ(whirls[0].pace, 3);
  EXPECT_EQ(whirls[0].turns, 1);
  EXPECT_EQ(whirls[1].profile, Profile::ball);
  EXPECT_EQ(whirls[1].ring_width, std::nullopt);
  EXPECT_EQ(whirls[1].pace, std::nullopt);
  EXPECT_TRUE(whirls[1].held);
  EXPECT_EQ(whirls[1].stretch(1, 2), 6);
  EXPECT_EQ(whirls[1].span[1], 3);
  read("  - {strength: 1}\n");
  EXPECT_EQ(whirls.size(), 1u) << "another list replaces the first";
}

TEST_F(KeyValues, AnchorsAndMergesWorkInsideItems) {
  read(
      "  - &first {strength: 0.4, turns: 3, profile: torus}\n"
      "  - {<<: *first, turns: 2}\n");
  ASSERT_EQ(whirls.size(), 2u);
  EXPECT_EQ(whirls[1].strength, 0.4);
  EXPECT_EQ(whirls[1].turns, 2);
  EXPECT_EQ(whirls[1].profile, Profile::torus);
}

TEST_F(KeyValues, WhatIsNoListOfMapsIsRefused) {
  const std::string must = "motion.whirls: must be a list of maps, found ";
  EXPECT_EQ(refused(""), "f:1:1: " + must + "nothing" + known);
  EXPECT_EQ(refused("  []\n"), "f:2:3: " + must + "an empty list" + known);
  EXPECT_EQ(refused("  ball\n"), "f:2:3: " + must + "'ball'" + known);
  EXPECT_EQ(refused("  strength: 1\n"), "f:2:3: " + must + "a map: each item begins with '-'" + known);
  EXPECT_EQ(refused("  - {strength: 1}\n  - 2\n"),
            std::string("f:3:5: motion.whirls[1]: must be a map of keys, found '2'") + known);
  EXPECT_EQ(refused("  - [1, 2]\n"),
            std::string("f:2:5: motion.whirls[0]: must be a map of keys, found a list: its keys stand without '-' and "
                        "brackets") +
                known);
}

TEST_F(KeyValues, KeysOfAnItemAreAsStrictAsOthers) {
  const auto item = [&](const std::string& keys) { return refused("  - {strength: 1}\n  - {" + keys + "}\n"); };
  EXPECT_EQ(item("strenth: 1"),
            std::string("f:3:6: motion.whirls[1].strenth: unknown key (nearest: strength)") + known);
  EXPECT_EQ(item("turns: 2"), "f:3:5: motion.whirls[1].strength: required and not given");
  EXPECT_EQ(item("strength: -1"), "f:3:16: motion.whirls[1].strength: must be greater than 0, found '-1'");
  EXPECT_EQ(item("strength: 1, turns: 2.5"), "f:3:26: motion.whirls[1].turns: must be a whole number, found '2.5'");
  EXPECT_EQ(item("strength: 1, turns: 10"), "f:3:26: motion.whirls[1].turns: must be from 1 to 9, found '10'");
  EXPECT_EQ(item("strength: 1, profile: bal"),
            "f:3:28: motion.whirls[1].profile: unknown value 'bal' (nearest: ball); known: ball, torus");
  EXPECT_EQ(item("strength: 1, centre: [1, 2]"),
            "f:3:27: motion.whirls[1].centre: must be a list of 3 numbers, found 2 in it");
  EXPECT_EQ(item("strength: 1, centre: [1, 2, x]"), "f:3:34: motion.whirls[1].centre[2]: must be a number, found 'x'");
  EXPECT_EQ(item("strength: 1, pace: fast"), "f:3:25: motion.whirls[1].pace: must be a number or auto, found 'fast'");
  EXPECT_EQ(item("strength: 1, held: 1"),
            "f:3:25: motion.whirls[1].held: must be true or false, found '1': write true");
  EXPECT_EQ(item("strength: 1, strength: 2"), "f:3:19: whirls[1].strength: duplicate key");
}

TEST_F(KeyValues, AKeyOfAnotherMapIsSentThere) {
  EXPECT_EQ(refused("  - {strength: 1, spacing: 1}\n"),
            std::string("f:2:19: motion.whirls[0].spacing: unknown key here: it belongs to grid") + known);
  EXPECT_EQ(
      refused("  - {strength: 1, grid: 1}\n"),
      std::string("f:2:19: motion.whirls[0].grid: unknown key here: it belongs to the scene itself, beside motion") +
          known);
}

TEST_F(KeyValues, PlacesOfItemsAndTheirKeysAreKnown) {
  const std::string yaml = "  - {strength: 1}\n  - turns: 2\n    strength: 3\n";
  scene.file = "f";
  scene.places = places_of_value(key, value(yaml));
  scene.places["motion"] = {"f", 9, 9};
  const auto at = [&](const std::string& path) {
    const Location where = scene.place(path);
    return std::to_string(where.line) + ":" + std::to_string(where.column);
  };
  EXPECT_EQ(at("motion.whirls"), "2:3");
  EXPECT_EQ(at("motion.whirls[0]"), "2:5");
  EXPECT_EQ(at("motion.whirls[0].strength"), "2:16");
  EXPECT_EQ(at("motion.whirls[1].turns"), "3:12");
  EXPECT_EQ(at("motion.whirls[1].strength"), "4:15");
  EXPECT_EQ(at("motion.whirls[1].centre"), "3:5") << "not given: the item";
  EXPECT_EQ(at("motion.whirls[1].centre[2]"), "3:5");
  EXPECT_EQ(at("motion.whirls[7].turns"), "2:3") << "no such item: the list";
  EXPECT_EQ(at("motion.period"), "9:9");
  EXPECT_EQ(refusal_of([&] { refuse(scene, "motion.whirls[1].turns", "is odd"); }),
            "f:3:12: motion.whirls[1].turns: is odd");
  EXPECT_TRUE(scene.places.contains("motion.whirls[1].turns"));
  EXPECT_FALSE(scene.places.contains("motion.whirls[0].turns"));
}

TEST_F(KeyValues, WhatIsWrittenReadsBackToTheBit) {
  read(
      "  - {profile: torus, strength: 0.1, centre: [1e-320, -0.0, 0.30000000000000004], ring_width: 1e300}\n"
      "  - {strength: 5e-324, label: 'a: {b}, #c', turns: 9, pace: 2.5}\n");
  const std::string once = written();
  const Value shown = key.get(scene);
  key.set(scene, read_value(key, *read_yaml(once, "f").find("whirls")));
  EXPECT_EQ(key.get(scene), shown);
  EXPECT_EQ(written(), once);
  EXPECT_TRUE(std::signbit(whirls[0].centre[1]));
  EXPECT_EQ(whirls[1].label, "a: {b}, #c");
}

TEST_F(KeyValues, EachItemIsWrittenInALine) {
  read("  - {strength: 0.5}\n  - {strength: 2, ring_width: 3, label: y}\n");
  const std::string others = "stretch: [[1, 0, 0], [0, 1, 0], [0, 0, 1]], span: [0, 1]}\n";
  EXPECT_EQ(
      written(),
      "whirls:\n"
      "    - {profile: ball, strength: 0.5, turns: 1, centre: [0, 0, 0], pace: auto, held: false, " +
          others +
          "    - {profile: ball, strength: 2, turns: 1, centre: [0, 0, 0], ring_width: 3, pace: auto, held: false, "
          "label: \"y\", " +
          others);
}

TEST_F(KeyValues, AListWithoutItemsIsNotWritten) { EXPECT_EQ(key.get(scene), Value()); }

TEST_F(KeyValues, SettingsReachAnItem) {
  Tree root = read_yaml("motion:\n  whirls:\n    - {strength: 1}\n    - {strength: 2, centre: [1, 2, 3]}\n", "f");
  const auto set = [&](const std::string& text) { apply_setting(root, parse_setting(text)); };
  const auto read_root = [&] { key.set(scene, read_value(key, *root.find("motion")->find("whirls"))); };
  set("motion.whirls[0].strength=0.3");
  set("motion.whirls.1.strength=0.7");
  set("motion.whirls[1].turns=4");
  set("motion.whirls[1].centre[2]=9");
  read_root();
  EXPECT_EQ(whirls[0].strength, 0.3);
  EXPECT_EQ(whirls[1].strength, 0.7);
  EXPECT_EQ(whirls[1].turns, 4);
  EXPECT_EQ(whirls[1].centre, Vector3(1, 2, 9));
  set("motion.whirls[0].turns=0");
  EXPECT_EQ(refusal_of(read_root), "--set motion.whirls[0].turns: must be from 1 to 9, found '0'");
  set("motion.whirls=[{strength: 5}]");
  read_root();
  ASSERT_EQ(whirls.size(), 1u);
  EXPECT_EQ(whirls[0].strength, 5);
}

TEST_F(KeyValues, TheSchemaTakesWhatTheReaderTakes) {
  const json schema = json::parse(type_schema(key).dump());
  EXPECT_EQ(schema["type"], "array");
  EXPECT_EQ(schema["minItems"], 1);
  const json& item = schema["items"];
  EXPECT_EQ(item["additionalProperties"], false);
  EXPECT_EQ(item["required"], json::array({"strength"}));
  EXPECT_EQ(item["properties"]["turns"]["default"], 1);
  EXPECT_EQ(item["properties"]["pace"]["default"], "auto");
  EXPECT_EQ(item["properties"]["profile"]["default"], "ball");
  EXPECT_FALSE(item["properties"]["ring_width"].contains("default"));
  EXPECT_EQ(item["properties"]["ring_width"]["description"], "width of a torus [m]; default: none");
  const char* const texts[] = {"  - {strength: 1}\n",
                               "  - {strength: 1, turns: 2, centre: [1, 2, 3], pace: auto, profile: torus}\n",
                               "  []\n",
                               "  - 1\n",
                               "  strength: 1\n",
                               "  - {turns: 2}\n",
                               "  - {strength: 0}\n",
                               "  - {strength: 1, turns: 2.5}\n",
                               "  - {strength: 1, centre: [1, 2]}\n",
                               "  - {strength: 1, profile: cube}\n",
                               "  - {strength: 1, width: 2}\n"};
  int taken = 0;
  for (const char* text : texts) {
    const bool is_taken = refused(text) == "accepted";
    EXPECT_EQ(valid(schema, json_of(value(text))), is_taken) << text;
    taken += is_taken ? 1 : 0;
  }
  EXPECT_EQ(taken, 2);
  read(texts[1]);
  EXPECT_TRUE(valid(schema, json_of(*read_yaml(written(), "f").find("whirls"))));
}

}  // namespace
}  // namespace assay::drivers::test_key_values
