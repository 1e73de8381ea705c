// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/units_hint.hpp"

#include <gtest/gtest.h>

#include "drivers/scene/scene_reader.hpp"
#include "tests/drivers/refusal.hpp"
#include "tests/drivers/scene_text.hpp"

namespace assay::drivers::test_units_hint {
namespace {

/// Steel in mm, MPa and s.
std::string steel(const std::string& head = {}, const std::string& period = "100") {
  return head + "motion: {type: vortex, inner: 7.5, outer: 12.5, period: " + period +
         ", amplitude: {peak: 0.25}}\n"
         "material: {adapter: neo_hookean, parameters: {E: 210000, nu: 0.3}, density: 7.85e-9}\n"
         "grid: {spacing: 1}\nmethod: {basis: cpdi}\nlimits: {particle_steps: 1.0e+9}\n";
}

std::string refusal(const std::string& text) {
  return refusal_of([&] { assemble<2>(scene_from_text(text, "f.yaml"), 1); });
}

const std::string line = "begin it with `units: {length: mm, stress: MPa, time: s}`";

TEST(UnitsHint, NamesTheLineToAdd) {
  EXPECT_NE(refusal(steel()).find(line), std::string::npos) << refusal(steel());
  EXPECT_NE(refusal(steel({}, "1.0e+12")).find(line), std::string::npos) << "too many to be told apart";
  EXPECT_EQ(refusal(steel("units: {length: mm, stress: MPa, time: s}\n")).find(line), std::string::npos);
  EXPECT_EQ(refusal(steel({}, "2.0e-6")), "accepted");
}

TEST(UnitsHint, WarnsBeforeManySteps) {
  PosedScene problem;
  problem.scene = scene_from_text(steel(), "f.yaml");
  problem.wave_speed = 6e6, problem.steps = 2'183'942;
  EXPECT_EQ(units_hint_for_many_steps(problem).substr(0, 17), "2,183,942 steps: ");
  problem.steps = 1000;
  EXPECT_EQ(units_hint_for_many_steps(problem), "");
  problem.wave_speed = 6e9;  // a density in t/mm^3 beside moduli in Pa: another message
  EXPECT_EQ(units_hint(problem), "");
}

TEST(UnitsHint, IsSilentOnHonestScenes) {
  int seen = 0;
  for (const std::string& file : all_configs()) {
    PosedScene problem;
    problem.scene = read_scene(file);
    if (problem.scene.material.density == 0) continue;
    problem.wave_speed = 1e6;  // whatever it is
    EXPECT_EQ(units_hint(problem), "") << file;
    ++seen;
  }
  EXPECT_GT(seen, 60);
}

}  // namespace
}  // namespace assay::drivers::test_units_hint
