// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/findings/findings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <regex>

#include "tests/drivers/process.hpp"
#include "tests/drivers/quiet_run.hpp"
#include "tests/drivers/scratch_folder.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_run_junit {
namespace {

const std::string vortex_scene = tree_folder() + "/configs/paper/vortex_cpdi.yaml";

/// A short run whose findings go to junit.xml. Returns that file's text.
std::string junit_of(int status, std::vector<std::string> sets) {
  const ScratchFolder scratch;
  sets.insert(sets.begin(), {"grid.spacing=0.125", "output.particles=0", "time.end=0.1"});
  RunOptions options = quiet_run("paper/vortex_cpdi", scratch / "out", sets);
  options.junit = scratch / "junit.xml";
  EXPECT_EQ(run(options), status);
  const double seconds =
      result_in(options.out)["setup_s"].get<double>() + result_in(options.out)["wall_s"].get<double>();
  const std::string text = bytes_of(options.junit);
  std::smatch found;
  EXPECT_TRUE(std::regex_search(text, found, std::regex("name=\"outcome\" time=\"([0-9.]+)\""))) << text;
  EXPECT_GE(std::stod(found[1]), seconds - 1e-3) << text;
  return text;
}

/// The file is what readers of JUnit files ask for (tests/drivers/junit.rng).
void expect_valid(const std::string& text) {
  if (std::system("xmllint --version > /dev/null 2>&1") != 0) return;  // Check.JUnitIsValid says so
  const ScratchFolder scratch;
  const std::string file = scratch.write("junit.xml", text), said = scratch / "said";
  const std::string command =
      "xmllint --noout --relaxng '" + tree_folder() + "/tests/drivers/junit.rng' '" + file + "' > '" + said + "' 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << bytes_of(said) << text;
}

void expect_in(const std::string& text, const std::vector<std::string>& parts) {
  expect_valid(text);
  for (const std::string& part : parts) EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

TEST(LongRunJUnit, HoldsTheOutcomeAndEveryExpectation) {
  const std::string text =
      junit_of(1, {"expect={outcome: completed, error.l2_max: {below: 1e-9}, t: {between: [0, 1]}, particles: 816}"});
  expect_in(
      text,
      {"<testsuite name=\"assay run Generalized vortex, CPDI\" package=\"assay.run\"",
       "tests=\"5\" failures=\"1\" errors=\"0\" skipped=\"0\"",
       "<testcase classname=\"assay.run.vortex_cpdi\" name=\"outcome equals\" time=\"0\"/>",
       "name=\"error.l2_max below\" time=\"0\">\n      <failure message=\"error.l2_max: expected below 1e-09, found ",
       "type=\"expectation\">error.l2_max: expected below 1e-09, found ", "name=\"t between\" time=\"0\"/>",
       "name=\"particles equals\""});
}

TEST(RunJUnit, TakesTheNameThatIsGiven) {
  const ScratchFolder scratch;
  RunOptions options =
      quiet_run("paper/vortex_cpdi", scratch / "out",
                {"expect={outcome: completed, uses_exact_solution: false}", "time.end=0.01", "output.pictures=false"});
  options.junit = scratch / "junit.xml";
  options.junit_name = "clay.fine";
  EXPECT_EQ(run(options), 0);
  expect_in(bytes_of(options.junit), {"<testsuite name=\"assay run clay.fine\" package=\"assay.run\"",
                                      "<testcase classname=\"assay.run.clay.fine\" name=\"outcome equals\"",
                                      "name=\"uses_exact_solution equals\""});
}

TEST(RunJUnit, WithoutExpectationsThereIsStillTheOutcome) {
  expect_in(junit_of(0, {}), {"tests=\"1\" failures=\"0\" errors=\"0\"", "name=\"outcome\""});
}

TEST(LongRunJUnit, ARunThatDiesSaysWhy) {
  const std::vector<std::string> dies{"method.basis=ugimp", "grid.spacing=0.05", "time.end=1"};
  std::vector<std::string> sets = dies;
  sets.push_back("expect={error.l2_end: {below: 1}}");
  expect_in(junit_of(1, sets), {"tests=\"2\" failures=\"2\" errors=\"0\"", "<failure message=\"the run was unstable: ",
                                "type=\"unstable\">the run was unstable: ", "found null; the run was unstable: "});
  sets.back() = "expect={outcome: unstable}";
  expect_in(junit_of(0, sets), {"tests=\"2\" failures=\"0\" errors=\"0\""});
  sets.back() = "expect={outcome: completed}";
  expect_in(junit_of(1, sets),
            {"tests=\"2\" failures=\"2\" errors=\"0\"",
             "<failure message=\"outcome: expected completed, found unstable; the run was unstable: "});
}

TEST(RunJUnit, AMaterialThatFailsIsAFailure) {
  const std::string sets = "material={adapter: " + built("tests/plugins/fails_when_sheared.so") +
                           ", parameters: {modulus: 1000}, density: 1000}";
  expect_in(junit_of(1, {sets, "time.end=1"}),
            {"tests=\"1\" failures=\"1\" errors=\"0\"",
             "<failure message=\"the material failed: ", "type=\"material_failed\">the material failed: "});
}

TEST(RunJUnit, ARefusedRunIsAnError) {
  const std::string jaumann = "material={adapter: hypoelastic_jaumann, parameters: {E: 1e3, nu: 0.3}, density: 1000}";
  const std::string text = junit_of(1, {jaumann, "force.tolerance=1e-6", "expect={error.l2_max: {below: 1}}"});
  expect_in(text, {"tests=\"2\" failures=\"0\" errors=\"2\"", "type=\"refused\">the run was refused: ",
                   "<error message=\"the run was refused: this motion is not a stable solution"});
}

/// The exit status and the file agree, whatever a result says.
TEST(RunJUnit, NoTestFailsWhereTheExitStatusIsZero) {
  RunOptions odd;
  odd.scene = "a <&\"'> b.yaml", odd.out = "out";
  for (const char* outcome : {"completed", "unstable", "refused"}) {
    for (const char* expected : {"", "completed", "unstable", "refused"}) {
      Result result;
      result.outcome = outcome;
      result.reason = "because <&\"'> \x01";
      if (*expected != '\0') {
        result.expect = {{"outcome", expected, outcome, std::string(expected) == outcome}};
      }
      const std::string text = run_junit(result, odd, 0.25);
      expect_valid(text);
      const bool good = text.find("failures=\"0\" errors=\"0\"") != std::string::npos;
      EXPECT_EQ(good, exit_status(result) == 0) << outcome << " " << expected;
    }
  }
}

class RunJUnitCommand : public testing::Test {
 protected:
  Ending call(std::vector<std::string> more) {
    std::vector<std::string> words{"run", vortex_scene, "-o", scratch_ / "out"};
    for (const char* set :
         {"grid.spacing=0.25", "time.end=0.05", "output={particles: 0, errors: 2, pictures: false}"}) {
      words.insert(words.end(), {"--set", set});
    }
    words.insert(words.end(), more.begin(), more.end());
    return assay(words);
  }

  ScratchFolder scratch_;
};
using LongRunJUnitCommand = RunJUnitCommand;

TEST_F(RunJUnitCommand, GoesWithJsonAndQuiet) {
  const std::string file = scratch_ / "junit.xml";
  const Ending json = call({"--json", "--quiet", "--junit", file});
  EXPECT_EQ(json.status, 0);
  EXPECT_EQ(nlohmann::json::parse(json.said)["outcome"], "completed");
  expect_in(bytes_of(file), {"tests=\"3\" failures=\"0\" errors=\"0\""});
  const Ending quiet = call({"--quiet", "--junit", scratch_ / "out/junit.xml"});  // beside the result
  EXPECT_EQ(quiet.status, 0);
  EXPECT_EQ(quiet.said, "");
  expect_valid(bytes_of(scratch_ / "out/junit.xml"));
  const Ending shown = call({"--quiet", "--junit", "-"});
  EXPECT_EQ(shown.status, 0);
  expect_in(shown.said, {"<?xml version=\"1.0\"", "<testsuite name="});
}

TEST_F(RunJUnitCommand, AnUnwritablePlaceCostsNoVerdict) {
  const std::string place = "/proc/x";
  const Ending ending = call({"--junit", place});
  EXPECT_EQ(ending.status, 3) << place;
  EXPECT_NE(ending.said.find("AS EXPECTED; results in"), std::string::npos) << ending.said;
  EXPECT_NE(ending.said.find(place + ": cannot be created"), std::string::npos) << ending.said;
  EXPECT_EQ(result_in(scratch_ / "out")["outcome"], "completed");
}

TEST_F(RunJUnitCommand, AFolderThatIsMissingIsNamedBeforeTheRun) {
  const std::string place = scratch_ / "none/junit.xml";
  const Ending ending = call({"--junit", place});
  EXPECT_EQ(ending.status, 3);
  EXPECT_EQ(ending.said, place + ": cannot be created: No such file or directory\n");
  EXPECT_FALSE(std::filesystem::exists(scratch_ / "out"));
  const Ending check = assay({"check", "neo_hookean", "--junit", place, "-o", scratch_ / "r"});
  EXPECT_EQ(check.status, 3);
  EXPECT_EQ(check.said, place + ": cannot be created: No such file or directory\n");
}

/// Whoever reads the file of an earlier run after one that failed would see a green test. A file of others is left.
TEST_F(RunJUnitCommand, AnEarlierFileIsGoneBeforeARunOrCheckBegins) {
  const std::string file = scratch_ / "junit.xml";
  ASSERT_EQ(call({"--junit", file}).status, 0);
  ASSERT_TRUE(std::filesystem::exists(file));
  EXPECT_EQ(call({"--junit", file, "--set", "grid.spacing=-1"}).status, 2);
  EXPECT_FALSE(std::filesystem::exists(file));
  ASSERT_EQ(assay({"check", "neo_hookean", "--quick", "--junit", file, "-o", scratch_ / "r"}).status, 0);
  EXPECT_EQ(assay({"check", "no_such_model", "--junit", file}).status, 2);
  EXPECT_FALSE(std::filesystem::exists(file));
  for (const auto& wrong : std::vector<std::vector<std::string>>{{"--nonsense", "--junit", file},
                                                                 {"--junit=" + file, "--quiet", "--verbose"},
                                                                 {"--junit", file, "--threads", "many"}}) {
    ASSERT_EQ(call({"--junit", file}).status, 0);
    EXPECT_EQ(call(wrong).status, 2);
    EXPECT_FALSE(std::filesystem::exists(file)) << wrong.front();
  }
  const std::string other = scratch_.write("other.xml", "<?xml version=\"1.0\"?>\n<testsuites>\n</testsuites>\n");
  EXPECT_EQ(call({"--junit", other, "--set", "grid.spacing=-1"}).status, 2);
  EXPECT_TRUE(std::filesystem::exists(other));
}

/// A log of CI would otherwise hold an exit status alone.
TEST_F(LongRunJUnitCommand, QuietSaysWhatIsNotAsExpectedAndNothingElse) {
  EXPECT_EQ(call({"--quiet"}).said, "");
  const Ending ending = call({"--quiet", "--set", "expect={error.l2_max: {below: 1.0e-9}}"});
  EXPECT_EQ(ending.status, 1);
  EXPECT_NE(ending.said.find(": NOT AS EXPECTED\n  FAILS error.l2_max below 1e-09: found "), std::string::npos)
      << ending.said;
  EXPECT_EQ(std::count(ending.said.begin(), ending.said.end(), '\n'), 2) << ending.said;
  const Ending table = assay({"tabulate", vortex_scene, "-o", scratch_ / "table", "--quiet", "--set",
                              "expect={sheet.error_tau: {below: 1.0e-300}}"});
  EXPECT_EQ(table.status, 1);
  EXPECT_NE(table.said.find("  FAILS sheet.error_tau below 1e-300: found "), std::string::npos) << table.said;
}

TEST_F(RunJUnitCommand, BadInputLeavesNoFile) {
  const std::string file = scratch_ / "junit.xml";
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{"--junit", file, "--set", "grid.spacing=-1"}, "grid.spacing"},
      {{"--junit", file, "--set", "limits.particle_steps=10"}, "limits"},
      {{"--junit", file, "--threads", "0"}, "--threads"},
      {{"--junit", ""}, "--junit"},
      {{"--junit", "-", "--json"}, "--junit"},
      {{"--junit", scratch_ / "out/result.json"}, "is a file of the result"},
      {{"--junit", scratch_ / "new/../out/particles_0001.vtu"}, "is a file of the result"},
      {{"--junit", vortex_scene}, "would replace an input of that name"}};
  for (const auto& [words, part] : cases) {
    const Ending ending = call(words);
    EXPECT_EQ(ending.status, 2) << part;
    EXPECT_NE(ending.said.find(part), std::string::npos) << ending.said;
    EXPECT_EQ(std::count(ending.said.begin(), ending.said.end(), '\n'), 1) << ending.said;
    EXPECT_FALSE(std::filesystem::exists(file)) << part;
    EXPECT_FALSE(std::filesystem::exists(scratch_ / "out")) << part;
  }
}

}  // namespace
}  // namespace assay::drivers::test_run_junit
