// SPDX-License-Identifier: BSD-3-Clause
// A wrong clock is named, and a method that is late by itself is not taken for one.
#include <gtest/gtest.h>

#include "drivers/judge/labels.hpp"
#include "tests/drivers/judge/planted.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_doubtful_clocks {
namespace {

using Names = std::vector<std::string>;
using Clock = std::function<double(double)>;

constexpr double small = 0.1 * Planted::error;  ///< beside a wrong clock nothing else is to be seen

class JudgeClocks : public testing::Test {
 protected:
  std::string file(const Planted& planted, const Names& groups = {"id", "X", "x", "v"}) {
    return scratch_.write("run_" + std::to_string(files_++) + ".csv", planted.text(groups));
  }
  Verdict judged(const std::vector<std::string>& runs, const std::string& scene = Planted().scene_file) {
    return verdict_of(scene, runs, scratch_);
  }
  bool warns(const Verdict& found, const std::string& words) {
    for (const auto& warning : found.json["warnings"]) {
      if (std::string(warning).find(words) != std::string::npos) return true;
    }
    return false;
  }
  void expect_no_label(const Verdict& found, const std::string& why) {
    for (const auto& run : found.json["runs"]) EXPECT_EQ(run["labels"].size(), 0U) << run["labels"].dump(1);
    EXPECT_TRUE(warns(found, why)) << found.json["warnings"].dump(1);
  }
  ScratchFolder scratch_;

 private:
  int files_ = 0;
};
using LongJudgeClocks = JudgeClocks;

Planted at(const Clock& label, double error, double apart = Planted::spacing) {
  Planted planted(Planted().scene_file, error, apart);
  planted.for_each([&](JudgedFrame& f) { f.t = label(f.t); });
  return planted;
}

Planted with_late_velocities(double lateness, double error, double apart) {
  Planted planted(Planted().scene_file, error, apart);
  planted.for_each([&](JudgedFrame& f) { f.v = planted.frame(f.t, -lateness).v; });
  return planted;
}

TEST_F(LongJudgeClocks, AreNamedWhereNothingElseIsWrong) {
  constexpr double alike = 0.05;  // of the fitted times, where errors are small
  const double plain = judged({file(Planted(Planted().scene_file, small))}).l2();
  const auto expect = [&](const Clock& label, const std::string& cause, const Names& groups) {
    const Verdict found = judged({file(at(label, small), groups)});
    EXPECT_EQ(found.status, 1);
    EXPECT_EQ(found.causes(), Names{cause}) << found.json["warnings"].dump(1);
    EXPECT_NEAR(found.l2(), plain, alike * plain) << cause;
  };
  for (const Names& groups : {Names{"id", "X", "x", "v"}, {"id", "x", "v"}, {"X", "x"}}) {
    expect([](double t) { return t + 0.02; }, clock_offset, groups);
    expect([](double t) { return 1.03 * t; }, clock_rate, groups);
    expect([](double t) { return 0.97 * t; }, clock_rate, groups);
  }
}

TEST_F(LongJudgeClocks, AFrameThatIsWrittenTwiceIsNamed) {
  Planted once_more;
  const double plain = judged({file(once_more)}).l2();
  for (std::size_t k = once_more.frames.size(); k-- > 1;) {
    const double t = once_more.frames[k].t;
    once_more.frames[k] = once_more.frames[k - 1];
    once_more.frames[k].t = t;
  }
  constexpr double last = (Planted::times - 2.0) / (Planted::times - 1);  // the error grows with time
  const Verdict found = judged({file(once_more)});
  EXPECT_EQ(found.causes(), (Names{clock_offset, "ends_early"}));
  EXPECT_NEAR(found.l2(), last * plain, 0.02 * plain);
}

TEST_F(LongJudgeClocks, OfOneGridAreADoubtWhereMoreIsWrong) {
  const Verdict found = judged({file(at([](double t) { return 1.03 * t; }, Planted::error))});
  expect_no_label(found, "give a finer grid");
  EXPECT_TRUE(warns(found, "the clock is "));
  expect_no_label(judged({file(with_late_velocities(0.01, small, Planted::spacing))}), "`time: {velocity: -0.0");
}

TEST_F(JudgeClocks, OfTwoGridsAreNamedWhereTheyStay) {
  const auto fast = [](double t) { return 1.03 * t; };
  Verdict found = judged({file(at(fast, Planted::error, 0.12)), file(at(fast, 0.25 * Planted::error))});
  EXPECT_EQ(found.status, 1);
  for (const auto& run : found.json["runs"]) EXPECT_EQ(run["labels"][0]["cause"], clock_rate);
  found = judged({file(with_late_velocities(0.01, Planted::error, 0.12)),
                  file(with_late_velocities(0.01, 0.25 * Planted::error, Planted::spacing))});
  EXPECT_EQ(found.status, 1);
  for (const auto& run : found.json["runs"]) EXPECT_EQ(run["labels"][0]["cause"], velocity_time);
}

TEST_F(LongJudgeClocks, OfTwoGridsAreTheMethodsWhereTheyFall) {
  const auto by = [](double rate) { return [rate](double t) { return rate * t; }; };
  const std::string why = "a method that is late by itself gets better";
  Verdict found = judged({file(at(by(1.04), Planted::error, 0.12)), file(at(by(1.01), 0.25 * Planted::error))});
  expect_no_label(found, why);
  EXPECT_EQ(found.status, 0) << found.json["verdict"];
  const auto later = [](double lateness) { return [lateness](double t) { return t > 0 ? t + lateness : t; }; };
  expect_no_label(judged({file(at(later(0.04), Planted::error, 0.12)), file(at(later(0.02), 0.25 * Planted::error))}),
                  why);
  expect_no_label(judged({file(with_late_velocities(0.02, Planted::error, 0.12)),
                          file(with_late_velocities(0.01, 0.25 * Planted::error, Planted::spacing))}),
                  why);
}

/// Wrong forces look like a slow clock, too; but then the rest of the error stays as it is.
TEST_F(LongJudgeClocks, AreNoneWhereTheRestStays) {
  const auto fast = [](double t) { return 1.03 * t; };
  expect_no_label(judged({file(at(fast, Planted::error, 0.12)), file(at(fast, Planted::error))}),
                  "does not fall on finer grids");
}

/// Linear elements are late by 1.1 % and 0.27 % in this wave.
TEST_F(LongJudgeClocks, OfAMethodOfOursAreNotAccused) {
  std::vector<std::string> runs;
  const std::string scene = tree_folder() + "/configs/standard/1/axis_aligned.yaml";
  for (const char* h : {"0.1", "0.05"}) {
    RunOptions options;
    options.scene = scene;
    options.out = runs.emplace_back(scratch_ / (std::string("h_") + h));
    options.sets = {"method={basis: linear, formulation: total, transfer: flip}", std::string("grid.spacing=") + h,
                    "expect={}", "output.errors=1"};
    options.verbosity = Verbosity::quiet;
    ASSERT_EQ(run(options), 0);
    const Verdict alone = judged({runs.back()}, scene);
    expect_no_label(alone, "give a finer grid");
  }
  const Verdict both = judged(runs, scene);
  expect_no_label(both, "a method that is late by itself gets better");
  EXPECT_EQ(both.status, 0) << both.json["verdict"];
}

}  // namespace
}  // namespace assay::drivers::test_doubtful_clocks
