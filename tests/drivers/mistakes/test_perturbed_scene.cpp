// SPDX-License-Identifier: BSD-3-Clause
// The perturbed problem without a mistake is the problem of the scene.
#include "drivers/mistakes/perturbed_scene.hpp"

#include <gtest/gtest.h>

#include "tests/drivers/mistakes/foreign_code.hpp"

namespace assay::drivers::test_perturbed_scene {
namespace {

struct Case {
  const char* name;
  std::string scene;
};

const std::string neo_hookean = "material: {adapter: neo_hookean, parameters: {E: 1000, nu: 0.3}, density: 1000}\n";
const std::string unit_box = "body: {domain: box, lower: [0, 0], upper: [1, 1]}\n";

const std::vector<Case>& cases() {
  static const std::vector<Case> all{
      {"vortex", "motion: {type: vortex, profile_power: 4, amplitude: {type: sine, peak: 0.5}}\n" + neo_hookean},
      {"vortex_in_a_square",
       "motion: {type: vortex, profile_power: 4, amplitude: {type: sine, peak: 0.5}}\n"
       "body: {domain: square, outside: free}\n" +
           neo_hookean},
      {"zener",
       "motion: {type: vortex, profile_power: 4, amplitude: {type: sine, peak: 0.3}}\n"
       "material: {adapter: zener, parameters: {E: 1000, nu: 0.3, viscous_ratio: 1, relaxation_time: 0.2}, density: "
       "1000}\n"},
      {"twisting_ring",
       "motion: {type: twisting_ring, inner: 0.75, outer: 1.25, period: 1, expansion: 0.1, amplitude: {type: sine, "
       "peak: 0.4}}\n" +
           neo_hookean},
      {"rotating_stretch",
       "motion: {type: rotating_stretch, stretch: 0.3, rotation: 1.2, rotate: simultaneous, period: 1}\n"
       "body: {domain: box, lower: [-0.5, -0.5], upper: [0.5, 0.5]}\n" +
           neo_hookean},
      {"axis_aligned", "motion: {type: axis_aligned, amplitude: {type: sine, peak: 0.05}}\n" + unit_box + neo_hookean},
      {"bar", "motion: {type: bar_1d, amplitude: {type: sine, peak: 0.05}}\n" + unit_box + neo_hookean}};
  return all;
}

class PerturbedScenes : public testing::TestWithParam<Case> {};

TEST_P(PerturbedScenes, WithoutAMistakeConvergeWithOrderTwo) {
  const ForeignCode code(GetParam().scene);
  const MeasuredErrors bins = code.run(Mistake(), 4);
  const double coarse = error_of_grid(code.scene(), code.problem(), bins.errors, 0.0625),
               fine = error_of_grid(code.scene(), code.problem(), bins.errors, 0.03125);
  constexpr double least_ratio = 3.2;  // 4 in the limit
  EXPECT_GT(coarse, 0);
  EXPECT_GT(coarse / fine, least_ratio) << coarse << " " << fine;
}

INSTANTIATE_TEST_SUITE_P(Motions, PerturbedScenes, testing::ValuesIn(cases()),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(PerturbedScene, SaysWhereMistakesAreNotLookedFor) {
  const auto why = [](const std::string& more) {
    ScratchFolder scratch;
    return why_no_mistakes(read_scene(scratch.write("scene.yaml", cases()[0].scene + more), {}));
  };
  EXPECT_EQ(why(""), "");
  EXPECT_EQ(why("frame: {spin: 1}\n"), "in a moving frame");
  EXPECT_EQ(why("force: {quasi_static: true}\n"), "without inertia");
}

/// Five rows of a smooth path: a cubic in between has an acceleration without jumps, a monotone one has not.
TEST(PerturbedScene, OfATableIsLookedAtWhereTheAccelerationIsSmooth) {
  const ScratchFolder scratch;
  scratch.write("path.csv",
                "t,F11,F12,F21,F22\n0,1,0,0,1\n0.25,1.1,0.1,0,1\n0.5,1.3,0,0,1.1\n0.75,1.1,-0.1,0,1\n1,1,0,0,1\n");
  const auto why = [&](const std::string& interpolation) {
    return why_no_mistakes(read_scene(
        scratch.write("scene.yaml", "motion: {type: homogeneous, path: path.csv, interpolation: " + interpolation +
                                        "}\nmaterial: {adapter: neo_hookean, parameters: {E: 1000, nu: 0.3}, density: "
                                        "1000}\nbody: {domain: box, lower: [0, 0], upper: [1, 1]}\n"),
        {}));
  };
  EXPECT_EQ(why("spline"), "");
  EXPECT_NE(why("monotone").find("whose acceleration jumps"), std::string::npos);
}

}  // namespace
}  // namespace assay::drivers::test_perturbed_scene
