// SPDX-License-Identifier: BSD-3-Clause
// `dimension` of a scene, and the keys that depend on it.
#include <gtest/gtest.h>

#include "drivers/scene/scene_reader.hpp"
#include "harness/motion/kinds/axis_aligned.hpp"
#include "tests/drivers/refusal.hpp"
#include "tests/drivers/scene_text.hpp"

namespace assay::drivers::test_dimension {
namespace {

std::string refused(const std::string& text) {
  return refusal_of([&] { scene_from_text(text, "f.yaml"); });
}
std::string refused_extra(const std::string& extra) { return refused(scene_text(extra)); }

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// At rest; there is no plane version of it.
struct Resting {
  ExactState at(const Vector3& X, double) const { return {.x = X}; }
  Path baseline() const { return Path(); }
};

class RestingKind final : public MotionOf<RestingKind, Resting> {
 public:
  using MotionOf::MotionOf;
  std::string_view type() const override { return "resting"; }
  double period() const override { return 1; }
  void keys(Keys&) override {}
  bool only_in_space() const override { return true; }
};

std::unique_ptr<MotionKind> kind_of(const Resting& motion) { return std::make_unique<RestingKind>(motion); }

TEST(Dimension, AMotionInSpaceOnlyHasNoPlaneVersion) {
  Scene scene = scene_from_text(homogeneous_text(), "f.yaml");
  scene.motion = Resting();
  const auto checked = [&] {
    return refusal_of([&] { check_scene(scene, [](const std::string&) { return Location{"f.yaml", 7, 12}; }); });
  };
  EXPECT_EQ(checked(), "f.yaml:7:12: dimension: must be 3 for motion.type resting, which has no plane version");
  scene.dimension = 3;
  EXPECT_EQ(checked(), "accepted");
}

TEST(Dimension, ADimensionOfThreeServesEveryMotion) {
  EXPECT_EQ(scene_from_text(scene_text(), "f.yaml").dimension, 2);
  EXPECT_EQ(scene_from_text("dimension: 3\n" + scene_text(), "f.yaml").dimension, 3);
  EXPECT_EQ(refused_extra("dimension: 2\n"), "accepted");
  EXPECT_EQ(refused_extra("dimension: 4\n"), "f.yaml:3:12: dimension: must be from 2 to 3, found '4'");
  EXPECT_EQ(refused_extra("dimension: 3\ngrid: {spacing: .1}\nmethod: {basis: cpdi}\n"), "accepted");
}

/// With a method: bodies and grids have three axes.
std::string refused_run(const std::string& extra) {
  return refused_extra("dimension: 3\ngrid: {spacing: .1}\nmethod: {basis: cpdi}\n" + extra);
}

TEST(Dimension, ARunInSpaceHasThreeNumbersForEachAxis) {
  EXPECT_EQ(refused_run("body: {per_cell: [2, 2]}\n"),
            "f.yaml:6:18: body.per_cell: must be a list of 3 whole numbers, found 2 in it");
  EXPECT_EQ(refused_run("body: {lower: [-2, -2, -1], upper: [2, 2, 1], per_cell: [2, 3, 1]}\n"), "accepted");
  EXPECT_EQ(refused_run("body: {lower: [-2, -2, 1], upper: [2, 2, 1]}\n"),
            "f.yaml:6:15: body.lower: must be less than body.upper, found [-2, -2, 1] and [2, 2, 1]");
  EXPECT_EQ(refused_extra("body: {domain: box, lower: [-2, -2, -1], upper: [2, 2, 1]}\n"),
            "f.yaml:3:28: body.lower: must be a list of 2 numbers, found 3 in it");
  const Scene s = scene_from_text("dimension: 3\ngrid: {spacing: .1}\nmethod: {basis: cpdi}\n" + scene_text(), "f");
  EXPECT_EQ(s.body.domain, Body::Domain::box);
  EXPECT_EQ(s.body.lower.size(), 3u);
  EXPECT_EQ(s.grid->offset.size(), 3u);
  EXPECT_EQ(s.force.evaluation, mpm::Evaluation::domain_average);  // of the paper's profile
}

TEST(Dimension, ABodyInSpaceIsABoxAroundTheVortexOrTheVortexItself) {
  EXPECT_EQ(refused_run("body: {domain: ring}\n"),
            "f.yaml:6:16: body.domain: ring lies in the plane, and dimension is 3: take box");
  EXPECT_EQ(refused_run("body: {domain: vortex}\n"),
            "f.yaml:6:16: body.domain: vortex is the body of motion.type vortex3d, and motion.type is vortex");
  EXPECT_EQ(refused_run("body: {lower: [-1, -2, 0], upper: [2, 2, 1]}\n"),
            "f.yaml:6:7: body.domain: must contain the vortex, which reaches from -1.25 to 1.25 along X, and reaches "
            "from [-1, -2, 0] to [2, 2, 1]");
  EXPECT_EQ(refused_extra("body: {domain: box, periodic: z}\n"),
            "f.yaml:3:21: body.periodic: does not belong to motion.type vortex; known: domain, outside, lower, upper, "
            "per_cell, lattice, jitter, seed, initial_velocity");
  EXPECT_EQ(refused_run("body: {periodic: z}\n"), "accepted");
  EXPECT_EQ(refused_run("body: {periodic: x}\n"), "f.yaml:6:18: body.periodic: vortex does not repeat along x");
}

TEST(Dimension, AFrameInSpaceTurnsAboutAnyAxisAndServesEveryMotion) {
  const std::string tilted = "frame: {angle: 1, axis: [1, 2, 3], velocity: [0.4, -0.2, 0.3]}\n";
  const Scene s = scene_from_text(homogeneous_text("dimension: 3\n" + tilted), "f.yaml");
  EXPECT_EQ(s.frame->axis, Vector3(1, 2, 3));
  EXPECT_EQ(s.frame->velocity, Vector3(0.4, -0.2, 0.3));
  EXPECT_EQ(refused_extra("dimension: 3\nframe: {velocity: [1, 2]}\n"), "accepted");
  EXPECT_EQ(refused_extra("dimension: 3\nbody: {domain: square}\nframe: {spin: 1}\n"), "accepted");
  EXPECT_EQ(refused_extra("frame: {axis: [0, 0, 2]}\n"), "accepted");
  EXPECT_EQ(refused_extra(tilted),
            "f.yaml:3:25: frame.axis: must be [0, 0, 1] in the plane: another axis needs dimension: 3");
  EXPECT_EQ(refused_extra("frame: {axis: [0, 0, -1]}\n"),
            "f.yaml:3:15: frame.axis: must be [0, 0, 1] in the plane: another axis needs dimension: 3");
  EXPECT_EQ(refused_extra("frame: {velocity: [1, 2, 3]}\n"),
            "f.yaml:3:19: frame.velocity: has two numbers in the plane: a third needs dimension: 3");
  EXPECT_EQ(refused_extra("dimension: 3\nframe: {axis: [0, 0, 0]}\n"), "f.yaml:4:15: frame.axis: must not be zero");
  EXPECT_EQ(refused_extra("dimension: 3\nframe: {velocity: [1]}\n"),
            "f.yaml:4:19: frame.velocity: must be a list of 2 numbers, found 1 in it");
}

TEST(Dimension, TheBoxHasAFactorForEachAxis) {
  const auto box = [](const std::string& keys, const std::string& extra = "") {
    return "motion: {type: axis_aligned, wave_speed: 1" + keys +
           "}\nmaterial: {adapter: neo_hookean, parameters: {E: 1e3}, density: 1000}\n" + extra;
  };
  const auto factors = [&](const std::string& text) {
    return scene_from_text(text, "f.yaml").motion.as<AxisAligned>()->s();
  };
  EXPECT_EQ(factors(box("")), Vector3(1, -1, 0));
  EXPECT_EQ(factors(box("", "dimension: 3\n")), Vector3(1, -1, 0.5));
  EXPECT_EQ(factors(box(", factors: [0.5, 2, 0]")), Vector3(0.5, 2, 0));
  EXPECT_EQ(factors(box(", factors: [1, -1, 0]", "dimension: 3\n")), Vector3(1, -1, 0));
  EXPECT_EQ(refused(box(", factors: [1, -1, 0.5]")),
            "f.yaml:1:54: motion.factors: the third must be 0 in the plane, found 0.5: with dimension: 3 it may be any "
            "number");
  EXPECT_TRUE(has(refused(box(", factors: [1, -4, 0]")),
                  "motion.factors: the largest in size, 4, times motion.amplitude.peak, 0.1, must be less than 1/pi"));
  EXPECT_TRUE(has(refused(box(", amplitude: {peak: 0.4}")),
                  "motion.amplitude.peak: must be less than 1/pi in size, for det F > 0, found 0.4"));
}

}  // namespace
}  // namespace assay::drivers::test_dimension
