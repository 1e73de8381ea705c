// SPDX-License-Identifier: BSD-3-Clause
// What judge says of runs that are wrong as a whole, and of folders with other files in them.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/drivers/judge/planted.hpp"
#include "tests/drivers/refusal.hpp"

namespace assay::drivers::test_judge_verdicts {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

class JudgeVerdicts : public testing::Test {
 protected:
  std::string file(const std::string& name, const Planted& planted) {
    return scratch_.write(name, planted.text({"id", "X", "x", "v"}));
  }
  Verdict of_runs(const Names& runs, const std::string& spacings = {}, const std::string& map = {}) {
    JudgeOptions options;
    options.scene = planted_.scene_file;
    options.runs = runs, options.spacings = spacings, options.map = map;
    options.out = scratch_ / "verdict";
    options.verbosity = Verbosity::quiet;
    testing::internal::CaptureStdout();
    Verdict verdict;
    try {
      verdict.status = judge_runs(options);
    } catch (...) {
      testing::internal::GetCapturedStdout();
      throw;
    }
    testing::internal::GetCapturedStdout();
    verdict.json = nlohmann::json::parse(bytes_of(scratch_ / "verdict/judge.json"));
    return verdict;
  }
  static bool says(const Verdict& verdict, const std::string& words) {
    return verdict.json["verdict"].get<std::string>().find(words) != std::string::npos;
  }
  Planted planted_;
  ScratchFolder scratch_;
};
using LongJudgeVerdicts = JudgeVerdicts;

TEST_F(JudgeVerdicts, ABodyThatDoesNotMoveIsNotGood) {
  planted_.for_each([](JudgedFrame& f) { f.x = f.X; });
  const Verdict found = of_runs({file("run.csv", planted_)});
  EXPECT_EQ(found.status, 1);
  EXPECT_TRUE(says(found, "of the motion itself")) << found.json["verdict"];
}

TEST_F(JudgeVerdicts, APictureShowsTheParticlesWhereTheErrorIsLargest) {
  of_runs({file("run.csv", planted_)});
  const std::string page = bytes_of(scratch_ / "verdict/report.html");
  EXPECT_TRUE(bytes_of(scratch_ / "verdict/error.png").starts_with("\x89PNG"));
  EXPECT_NE(page.find("data:image/png;base64,"), std::string::npos);
  EXPECT_NE(page.find("t = 1 s"), std::string::npos);  // the planted error grows
}

TEST_F(JudgeVerdicts, ResultsOfARunAreNotReplaced) {
  fs::create_directory(scratch_ / "verdict");
  for (const char* name : {"verdict/result.json", "verdict/report.html"}) scratch_.write(name, "of a run");
  const std::string line = refusal_of([&] { of_runs({file("run.csv", planted_)}); });
  EXPECT_NE(line.find("a run (result.json)"), std::string::npos) << line;
  EXPECT_EQ(bytes_of(scratch_ / "verdict/result.json"), "of a run");
  EXPECT_EQ(bytes_of(scratch_ / "verdict/report.html"), "of a run");
}

TEST_F(LongJudgeVerdicts, OfFewerRunsLeaveNoTablesOfAnEarlierOne) {
  const std::string run = file("run.csv", planted_);
  const std::string finer = file("finer.csv", Planted(planted_.scene_file, 0.25 * Planted::error));
  of_runs({run, finer}, "0.1,0.05");
  EXPECT_TRUE(fs::exists(scratch_ / "verdict/errors_1.csv"));
  of_runs({finer});
  EXPECT_FALSE(fs::exists(scratch_ / "verdict/errors_1.csv"));
  EXPECT_TRUE(fs::exists(scratch_ / "verdict/errors.csv"));
}

TEST_F(LongJudgeVerdicts, AnErrorThatDoesNotFallIsNotGood) {
  const std::string run = file("run.csv", planted_);
  const Verdict found = of_runs({run, run}, "0.1,0.05");
  EXPECT_EQ(found.status, 1);
  EXPECT_TRUE(says(found, "does not fall")) << found.json["verdict"];
  const std::string finer = file("finer.csv", Planted(planted_.scene_file, 0.25 * Planted::error));
  const Verdict right = of_runs({run, finer}, "0.1,0.05");
  EXPECT_EQ(right.status, 0);
  EXPECT_NE(std::string(right.json["mistakes_of_code"]["sentence"]).find("a wrong bulk modulus is not seen"),
            std::string::npos);
}

/// As under gravity: no force that turns with the body does that.
TEST_F(LongJudgeVerdicts, AnErrorThatGoesAroundTheRingOnceIsSaidToDoSo) {
  const auto fallen = [](double apart) {
    Planted planted(Planted().scene_file, 0.01 * Planted::error, apart);
    planted.for_each([](JudgedFrame& f) {
      for (Vector3& x : f.x) x.y() -= 0.05 * f.t * f.t;
    });
    return planted;
  };
  const Verdict found = of_runs({file("coarse.csv", fallen(0.12)), file("fine.csv", fallen(0.06))});
  const auto& code = found.json["mistakes_of_code"];
  EXPECT_EQ(code["answer"], "unknown") << code.dump(1).substr(0, 2000);
  EXPECT_NE(std::string(code["sentence"]).find("goes around the ring once, as of a force of one direction"),
            std::string::npos)
      << code["sentence"];
}

TEST_F(JudgeVerdicts, ARunThatBlowsUpIsNotALabel) {
  planted_.for_each([](JudgedFrame& f) {
    for (std::size_t p = 0; f.t > 0.3 && p < f.x.size(); ++p) f.x[p] *= 1e6 * std::sin(static_cast<double>(p));
  });
  const Verdict found = of_runs({file("run.csv", planted_)});
  EXPECT_EQ(found.status, 1);
  EXPECT_TRUE(found.causes().empty()) << found.json["runs"][0]["labels"];
  EXPECT_TRUE(says(found, "of the motion itself")) << found.json["verdict"];
}

TEST_F(JudgeVerdicts, TwoFramesWithTheRightTimesHaveNoLabelOfAClock) {
  planted_.frames = {planted_.frames.front(), planted_.frames.back()};
  const Verdict found = of_runs({file("run.csv", planted_)});
  EXPECT_EQ(found.status, 0) << found.json.dump(1);
  ASSERT_EQ(found.json["warnings"].size(), 1u);
  EXPECT_NE(found.json["warnings"][0].get<std::string>().find("never moved"), std::string::npos);
}

TEST_F(JudgeVerdicts, TimesInMillisecondsHaveAName) {
  const double plain = of_runs({file("run.csv", planted_)}).l2();
  planted_.for_each([](JudgedFrame& f) { f.t *= 1e3; });
  const Verdict found = of_runs({file("run.csv", planted_)});
  EXPECT_EQ(found.causes(), Names{"time_unit"}) << found.json["runs"][0]["labels"];
  EXPECT_NEAR(found.l2(), plain, 1e-9);
}

TEST_F(JudgeVerdicts, VelocitiesInTheirOwnUnitAreNamedByThatUnit) {
  planted_.for_each([](JudgedFrame& f) {
    for (Vector3& x : f.x) x *= 1e3;
    for (Vector3& X : f.X) X *= 1e3;
  });
  const std::string run = file("run.csv", planted_);
  const Verdict found = of_runs({run}, {}, scratch_.write("a.yaml", "units: {length: mm}\n"));
  EXPECT_EQ(found.causes(), Names{"velocity_unit"});
  EXPECT_NE(found.run()["labels"][0]["sentence"].get<std::string>().find("velocity: m/s"), std::string::npos);
  EXPECT_EQ(of_runs({run}, {}, scratch_.write("b.yaml", "units: {length: mm, velocity: m/s}\n")).status, 0);
}

TEST_F(LongJudgeVerdicts, OtherFilesInTheFolderAreLeftOut) {
  fs::create_directory(scratch_ / "run");
  for (std::size_t k = 0; k < planted_.frames.size(); ++k) {
    Planted one = planted_;
    one.frames = {planted_.frames[k]};
    file("run/state_" + std::to_string(k) + ".csv", one);
  }
  const double plain = of_runs({scratch_ / "run"}).l2();
  for (const char* name : {"run/log.txt", "run/energy.csv", "run/state_4_backup.csv"})
    scratch_.write(name, "no particles at all\n");
  const Verdict found = of_runs({scratch_ / "run"});
  EXPECT_EQ(found.status, 0);
  EXPECT_EQ(found.l2(), plain);
  EXPECT_EQ(found.run()["left_out"], (Names{"energy.csv", "log.txt", "state_4_backup.csv"}));
}

TEST_F(JudgeVerdicts, SpacingsOfAnotherOrderAreRefused) {
  Planted coarse = planted_;
  coarse.for_each([](JudgedFrame& f) {  // every second particle along a line of the lattice, and every second line
    JudgedFrame kept;
    kept.t = f.t;
    for (std::size_t p = 0; p < f.x.size(); ++p) {
      const auto index = [](double x) { return std::lround((x + 1.5) / Planted::spacing - 0.5); };
      if (index(f.X[p].x()) % 2 != 0 || index(f.X[p].y()) % 2 != 0) continue;
      kept.id.push_back(f.id[p]), kept.X.push_back(f.X[p]), kept.x.push_back(f.x[p]), kept.v.push_back(f.v[p]);
    }
    f = kept;
  });
  const std::string fine = file("fine.csv", planted_), sparse = file("sparse.csv", coarse);
  const std::string line = refusal_of([&] { of_runs({sparse, fine}, "0.06,0.12"); });
  EXPECT_NE(line.find("--h"), std::string::npos) << line;
}

TEST_F(JudgeVerdicts, WordsInPlaceOfNumbersAreNamed) {
  const std::string run = scratch_.write("run.csv", "t;id;x;y\n0;1;0,5;1,5\n0;2;0,25;0,5\n");
  const std::string map = scratch_.write("map.yaml", "x: [x, y]\n");
  const std::string line = refusal_of([&] { of_runs({run}, {}, map); });
  EXPECT_NE(line.find("'0,5', a decimal comma?"), std::string::npos) << line;
}

}  // namespace
}  // namespace assay::drivers::test_judge_verdicts
