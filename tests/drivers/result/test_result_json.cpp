// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/result/result_json.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

namespace assay::drivers::test_result_json {
namespace {

using Json = nlohmann::json;

std::set<std::string> keys_of(const Json& object) {
  std::set<std::string> keys;
  for (const auto& item : object.items()) keys.insert(item.key());
  return keys;
}

TEST(ResultJson, has_every_key_before_anything_was_reached) {
  const Json json = Json::parse(result_json(Result{}));
  EXPECT_EQ(keys_of(json), (std::set<std::string>{"outcome",
                                                  "reason",
                                                  "warnings",
                                                  "t",
                                                  "dt",
                                                  "steps",
                                                  "particles",
                                                  "particles_held",
                                                  "uses_exact_solution",
                                                  "error",
                                                  "setup_s",
                                                  "wall_s",
                                                  "finish_s",
                                                  "cpu_s",
                                                  "step_cpu_s",
                                                  "peak_rss_bytes",
                                                  "work",
                                                  "particle_steps_per_s",
                                                  "passes",
                                                  "sheet",
                                                  "drift",
                                                  "health",
                                                  "last_good",
                                                  "expect",
                                                  "provenance",
                                                  "reference",
                                                  "replay",
                                                  "screen",
                                                  "rim",
                                                  "growth"}));
  EXPECT_EQ(keys_of(json["error"]),
            (std::set<std::string>{"l2_half", "l2_end", "l2_max", "linf_max", "rms36_half", "rms36_end", "rms36_max",
                                   "velocity", "deformation_gradient", "jacobian", "stress", "relative"}));
  for (const char* field : {"velocity", "deformation_gradient", "jacobian", "stress"}) {
    EXPECT_EQ(keys_of(json["error"][field]), (std::set<std::string>{"l2_max", "linf_max"})) << field;
    EXPECT_TRUE(json["error"][field]["l2_max"].is_null());
  }
  EXPECT_EQ(keys_of(json["work"]),
            (std::set<std::string>{"particle_steps", "material_calls", "hand_overs", "wake_ups", "bytes"}));
  EXPECT_EQ(keys_of(json["sheet"]),
            (std::set<std::string>{"points", "error_tau", "error_dtau", "error_b", "wall_s", "cached"}));
  EXPECT_EQ(keys_of(json["drift"]), (std::set<std::string>{"mass", "momentum", "angular_momentum", "energy"}));
  EXPECT_EQ(keys_of(json["provenance"]),
            (std::set<std::string>{"version", "git", "compiler", "flags", "libraries", "material", "scene_sha256"}));
  EXPECT_TRUE(json["sheet"]["points"].is_null());
  EXPECT_TRUE(json["steps"].is_null());
  EXPECT_TRUE(json["particles_held"].is_null());
  EXPECT_EQ(json["uses_exact_solution"], false);
}

TEST(ResultJson, carries_values_and_turns_what_is_not_finite_into_null) {
  Result result;
  result.outcome = "unstable";
  result.reason = "det F <= 0";
  result.error.l2_max = 0.1 + 0.2;
  result.error.linf_max = std::numeric_limits<double>::infinity();
  result.error.velocity.l2_max = std::numeric_limits<double>::quiet_NaN();
  result.steps = 1234;
  result.particle_steps = std::int64_t{1} << 60;
  result.sheet = SheetFigures{65, 1e-11, std::numeric_limits<double>::quiet_NaN(), 0.5};
  result.passes = {{"weights", 0.25, 96}};
  result.expect = {{"outcome", "equals completed", "unstable", false}};
  const std::string text = result_json(result);
  EXPECT_EQ(text.back(), '\n');
  const Json json = Json::parse(text);
  EXPECT_EQ(json["reason"], "det F <= 0");
  EXPECT_EQ(json["error"]["l2_max"].get<double>(), 0.1 + 0.2);
  EXPECT_TRUE(json["error"]["linf_max"].is_null());
  EXPECT_TRUE(json["error"]["velocity"]["l2_max"].is_null());
  EXPECT_EQ(json["work"]["particle_steps"].get<std::int64_t>(), std::int64_t{1} << 60);
  EXPECT_TRUE(json["sheet"]["error_dtau"].is_null());
  EXPECT_EQ(json["sheet"]["points"], 65);
  EXPECT_EQ(json["passes"][0]["name"], "weights");
  EXPECT_EQ(json["passes"][0]["bytes_per_particle"], 96);
  EXPECT_EQ(json["expect"][0]["holds"], false);
}

TEST(ResultJson, survives_text_that_is_no_utf8) {
  Result result;
  result.reason = "worker said \xff\xfe";
  EXPECT_TRUE(Json::accept(result_json(result)));
}

TEST(ResultJson, flat_keys_are_the_leaves) {
  const std::vector<std::string> keys = flat_keys();
  for (const char* key : {"outcome", "t", "error.l2_max", "error.velocity.linf_max", "work.material_calls",
                          "drift.energy", "sheet.error_tau", "provenance.version"}) {
    EXPECT_NE(std::find(keys.begin(), keys.end(), key), keys.end()) << key;
  }
  for (const char* key : {"error", "passes", "expect", "provenance.libraries", ""}) {
    EXPECT_EQ(std::find(keys.begin(), keys.end(), key), keys.end()) << key;
  }
  Result result;
  result.error.l2_max = 0.06;
  result.particles = 5032;
  const auto flat = flatten(result);
  EXPECT_EQ(flat.size(), keys.size());
  EXPECT_EQ(std::get<double>(flat.at("error.l2_max")), 0.06);
  EXPECT_EQ(std::get<double>(flat.at("particles")), 5032);
  EXPECT_EQ(std::get<std::string>(flat.at("outcome")), "completed");
  EXPECT_TRUE(std::holds_alternative<std::monostate>(flat.at("error.l2_half")));
}

TEST(ResultJson, is_read_back) {
  Result result;
  result.error.l2_max = 0.1 + 0.2;
  result.particle_steps = 100;
  result.passes = {{"stress", 0.25, 152}, {"weights", 0.5, 48}};
  const auto read = read_result_json(result_json(result));
  ASSERT_TRUE(read);
  EXPECT_TRUE(read->figures == flatten(result));
  ASSERT_EQ(read->passes.size(), 2u);
  EXPECT_EQ(read->passes[0].name, "stress");
  EXPECT_EQ(read->passes[1].bytes_per_particle, 48);
  EXPECT_EQ(std::get<double>(read->figures.at("work.bytes")), 100 * (152 + 48.0));
}

TEST(ResultJson, what_is_torn_is_not_read) {
  const std::string text = result_json(Result{});
  for (const std::size_t length : {std::size_t{0}, std::size_t{1}, text.size() / 2, text.size() - 3}) {
    EXPECT_FALSE(read_result_json(text.substr(0, length))) << length;
  }
  for (const char* other : {"[]", "3", "{}", R"({"outcome": 3})", R"({"outcome": "completed", "passes": [7]})",
                            R"({"outcome": "completed", "passes": [{"seconds": 1}]})"}) {
    EXPECT_FALSE(read_result_json(other)) << other;
  }
}

}  // namespace
}  // namespace assay::drivers::test_result_json
