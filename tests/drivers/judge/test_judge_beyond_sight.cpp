// SPDX-License-Identifier: BSD-3-Clause
// What judge cannot see it does not call good: particles in another unit, elsewhere, or told by their places alone.
#include <gtest/gtest.h>

#include "tests/drivers/judge/planted.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_judge_beyond_sight {
namespace {

using Names = std::vector<std::string>;

void scale(Planted& planted, double factor) {
  planted.for_each([&](JudgedFrame& f) {
    for (Vector3& X : f.X) X *= factor;
    for (Vector3& x : f.x) x *= factor;
    for (Vector3& v : f.v) v *= factor;
  });
}

/// A code as wrong as the motion is wide.
Planted wrong(const std::string& scene = Planted().scene_file) { return Planted(scene, 0.6); }

class JudgeBeyondSight : public testing::Test {
 protected:
  Verdict of(const Planted& planted, const Names& groups, const std::string& map = {}) {
    return verdict_of(planted.scene_file, {scratch_.write("run.csv", planted.text(groups))}, scratch_,
                      map.empty() ? map : scratch_.write("map.yaml", map));
  }
  static bool says(const Verdict& verdict, const std::string& words) {
    return verdict.json["verdict"].get<std::string>().find(words) != std::string::npos;
  }
  ScratchFolder scratch_;
};
using LongJudgeBeyondSight = JudgeBeyondSight;

TEST_F(LongJudgeBeyondSight, AWrongCodeInAnotherUnitIsToldItsUnitAndItsError) {
  Planted planted = wrong();
  const double plain = of(planted, {"id", "X", "x", "v"}).l2();
  for (const auto& [factor, unit] : {std::pair{1e3, "mm"}, {1e2, "cm"}, {1e-3, "km"}, {1 / 0.0254, "in"}}) {
    Planted scaled = planted;
    scale(scaled, factor);
    const Verdict found = of(scaled, {"id", "X", "x", "v"});
    EXPECT_EQ(found.status, 1) << unit;
    ASSERT_EQ(found.causes(), Names{"length_unit"}) << unit << found.run()["labels"];
    const std::string sentence = found.run()["labels"][0]["sentence"];
    EXPECT_NE(sentence.find(std::string("{length: ") + unit + "}"), std::string::npos) << sentence;
    EXPECT_EQ(sentence.find("inf"), std::string::npos) << sentence;
    EXPECT_NEAR(found.l2(), plain, 1e-9) << unit;
  }
}

TEST_F(JudgeBeyondSight, AWrongCodeUnderAHomogeneousMotionIsToldItsUnit) {
  Planted planted = wrong(tree_folder() + "/configs/standard/1/homogeneous_traction.yaml");
  scale(planted, 1e3);
  const Verdict found = of(planted, {"id", "X", "x", "v"});
  EXPECT_EQ(found.status, 1);
  EXPECT_EQ(found.causes(), Names{"length_unit"}) << found.json["verdict"];
}

TEST_F(JudgeBeyondSight, ABodyBesideWhatMovesIsNotGood) {
  Planted planted;
  scale(planted, 2);  // no unit, and beyond the ring
  const Verdict found = of(planted, {"id", "X", "x"});
  EXPECT_EQ(found.status, 1);
  EXPECT_TRUE(says(found, "nothing is measured")) << found.json["verdict"];
  EXPECT_EQ(found.run()["measured"], 0);
  EXPECT_TRUE(found.run()["error"]["l2_max"].is_null()) << found.run()["error"];
}

TEST_F(LongJudgeBeyondSight, OfParticlesWithoutNamesALargeErrorIsNotMeasured) {
  const double beyond = 0.35 * Planted::spacing;  // no two of them fall on one
  const Verdict found = of(Planted(Planted().scene_file, beyond), {"x", "v"});
  EXPECT_EQ(found.status, 1);
  EXPECT_TRUE(says(found, "cannot be measured")) << found.json["verdict"];
  EXPECT_EQ(found.json["mistakes_of_code"]["answer"], "unknown");
  EXPECT_NE(found.json["mistakes_of_code"]["sentence"].get<std::string>().find("ids or reference positions"),
            std::string::npos);
}

TEST_F(LongJudgeBeyondSight, OfParticlesWithoutNamesASmallErrorIs) {
  const Verdict found = of(Planted(), {"x", "v"});
  EXPECT_EQ(found.status, 0) << found.json["verdict"];
  EXPECT_NEAR(found.l2(), of(Planted(), {"id", "X", "x", "v"}).l2(), 1e-9);
}

TEST_F(LongJudgeBeyondSight, OfTwoGridsWithoutNamesNoOrderIsToldEither) {
  const Planted coarse = wrong(), fine(Planted().scene_file, 0.6, 0.5 * Planted::spacing);
  const Verdict found = verdict_of(
      coarse.scene_file,
      {scratch_.write("coarse.csv", coarse.text({"x"})), scratch_.write("fine.csv", fine.text({"x"}))}, scratch_);
  EXPECT_EQ(found.status, 1);
  EXPECT_TRUE(says(found, "cannot be measured")) << found.json["verdict"];
  EXPECT_TRUE(found.json["order"].is_null());
}

/// A scene of other parameters than those of the run.
TEST_F(LongJudgeBeyondSight, AnotherSceneIsToldByItsVelocitiesAtTheStart) {
  const std::string scene = bytes_of(Planted().scene_file);
  for (const auto& [from, to] : {std::pair{"peak: 1.0", "peak: 0.7"}, {"profile_power: 2", "profile_power: 4"}}) {
    std::string other = scene;
    ASSERT_NE(other.find(from), std::string::npos) << scene;
    other.replace(other.find(from), std::string(from).size(), to);
    const std::string file = scratch_.write("other.yaml", other);
    const Verdict found =
        verdict_of(file, {scratch_.write("run.csv", Planted().text({"id", "X", "x", "v"}))}, scratch_);
    EXPECT_EQ(found.status, 1) << to;
    EXPECT_TRUE(says(found, "velocities at t = 0")) << to << found.json["verdict"];
    EXPECT_NE(found.json["mistakes_of_code"]["answer"], "named") << found.json["mistakes_of_code"];
  }
}

/// The motion is that of the scene whatever the material is, so u falls with the grid.
TEST_F(LongJudgeBeyondSight, AStressOfAnotherMaterialIsNotGood) {
  std::string other = bytes_of(Planted().scene_file);
  const std::string from = "E: 1.0e+3";
  ASSERT_NE(other.find(from), std::string::npos) << other;
  const Planted coarse, fine(Planted().scene_file, 0.25 * Planted::error, 0.5 * Planted::spacing);
  const Names runs{scratch_.write("coarse.csv", coarse.text({"id", "X", "x", "sigma"})),
                   scratch_.write("fine.csv", fine.text({"id", "X", "x", "sigma"}))};
  EXPECT_EQ(verdict_of(coarse.scene_file, runs, scratch_).status, 0);
  const Verdict found = verdict_of(
      scratch_.write("other.yaml", other.replace(other.find(from), from.size(), "E: 2.0e+3")), runs, scratch_);
  EXPECT_EQ(found.status, 1);
  EXPECT_TRUE(says(found, "the error of the stress does not fall")) << found.json["verdict"];
}

TEST_F(LongJudgeBeyondSight, AUnitOfTheMapThatMakesTheBodyTooLargeIsWarnedOf) {
  Planted planted;
  scale(planted, 1e3);
  const auto warnings = [&](const std::string& unit) {
    return of(planted, {"id", "X", "x", "v"}, "units: {length: " + unit + "}\n").json["warnings"].dump();
  };
  EXPECT_NE(warnings("cm").find("times as large as that of the scene"), std::string::npos) << warnings("cm");
  EXPECT_EQ(warnings("mm").find("times as large"), std::string::npos) << warnings("mm");
}

TEST_F(JudgeBeyondSight, ColumnsThatNoMapNamesAreListed) {
  std::string text = Planted().text({"id", "X", "x"});
  text.replace(text.find("X,Y"), 3, "a,b");
  const Verdict found = verdict_of(Planted().scene_file, {scratch_.write("run.csv", text)}, scratch_);
  EXPECT_NE(found.run()["read"].get<std::string>().find("not read, for no map names them: a, b"), std::string::npos)
      << found.run()["read"];
}

}  // namespace
}  // namespace assay::drivers::test_judge_beyond_sight
