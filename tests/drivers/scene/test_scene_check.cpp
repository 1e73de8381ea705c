// SPDX-License-Identifier: BSD-3-Clause
// Keys of a scene that do not go together.
#include <gtest/gtest.h>

#include "drivers/scene/scene_reader.hpp"
#include "tests/drivers/refusal.hpp"

namespace assay::drivers::test_scene_check {
namespace {

const std::string head = "units: {length: mm, stress: MPa, time: ms}\n";

/// Digits that are no numbers of the author stay as they are.
TEST(SceneCheck, RefusesInTheUnitsOfTheScene) {
  const auto said = [](const std::string& motion, const std::string& more = "", const std::string& units = head) {
    const std::string text = units + "motion: " + motion + more +
                             "\nmaterial: {adapter: neo_hookean, parameters: {E: 1, nu: 0.3}, density: 1}\n";
    return refusal_of([&] { scene_from_text(text, "f"); });
  };
  const std::string twice = "{type: vortex, inner: 2000, amplitude: {peak: 0.1}}";
  EXPECT_EQ(said(twice), "f:2:31: motion.inner: must be less than motion.outer, found 2000 mm and 1250 mm");
  EXPECT_EQ(said("{type: vortex, inner: 2, amplitude: {peak: 0.1}}", "", ""),
            "f:1:31: motion.inner: must be less than motion.outer, found 2 and 1.25");
  const std::string vortex = "{type: vortex, amplitude: {peak: 0.1}}";
  EXPECT_NE(said(vortex, "\nbody: {domain: box, lower: [-1e3, -1e3], upper: [1e3, 1e3]}")
                .find("must contain the ring of the vortex (outer 1250 mm), reaches from [-1000, -1000] mm to [1000, "
                      "1000] mm"),
            std::string::npos);
  EXPECT_NE(said(vortex, "\ntime: {end: 100, step: 200}").find("must not exceed time.end, found 200 ms"),
            std::string::npos);
  EXPECT_NE(said("{type: axis_aligned, amplitude: {peak: 400}}")
                .find("must be less than 1/pi m in size, for det F > 0, "
                      "found 400 mm"),
            std::string::npos);
  EXPECT_NE(said("{type: homogeneous, period: 500, final: [[-1, 0, 0], [0, 1, 0], [0, 0, 1]]}")
                .find("det F <= 0 on the way, at t = 250 ms"),
            std::string::npos);
  const std::string sheared = refusal_of([&] {
    scene_from_text(head + "motion: " + vortex +
                        "\nmaterial: {adapter: neo_hookean, parameters: {E: 1, nu: 0.3}, density: 1, initial_stress: "
                        "[1, 2, 0, 0, 0, 0]}\n",
                    "f");
  });
  EXPECT_TRUE(
      sheared.ends_with("must have equal components 11 and 22 and no shear: no other stress is the same all "
                        "around the ring"))
      << sheared;
}

}  // namespace
}  // namespace assay::drivers::test_scene_check
