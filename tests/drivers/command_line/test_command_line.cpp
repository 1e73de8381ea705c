// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/command_line/command_line.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "drivers/system/input_error.hpp"
#include "tests/drivers/call_verb.hpp"
#include "tests/drivers/registry_fixture.hpp"
#include "tests/drivers/scene_text.hpp"
#include "tests/drivers/scratch_folder.hpp"

namespace assay::drivers::test_command_line {
namespace {

/// The verbs that the help lists.
std::vector<std::string> verbs_of_help() {
  std::vector<std::string> verbs;
  std::istringstream lines(call_verb({"--help"}).out);
  for (std::string line; std::getline(lines, line) && line != "Subcommands:";) continue;
  for (std::string line; std::getline(lines, line) && !line.empty();)
    verbs.push_back(line.substr(2, line.find(' ', 2) - 2));
  return verbs;
}

class CommandLine : public RegistryTest {
 protected:
  /// The one line that `run` prints for a scene with a setting that is refused before anything is run.
  std::string refused(const std::vector<std::string>& more) {
    std::vector<std::string> words{"run", write("scene.yaml", scene_text()), "-o", (folder / "out").string()};
    words.insert(words.end(), more.begin(), more.end());
    const VerbOutcome outcome = call_verb(words);
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "out/result.json"));
    return outcome.err;
  }
};

TEST_F(CommandLine, HelpReadsWellAtEightyColumns) {
  std::vector<std::vector<std::string>> calls{{"--help"}, {"-h"}};
  const std::vector<std::string> verbs = verbs_of_help();
  EXPECT_GE(verbs.size(), 12u);
  for (const std::string& verb : verbs) calls.push_back({verb, "--help"});
  for (const auto& words : calls) {
    const VerbOutcome help = call_verb(words);
    EXPECT_EQ(help.status, 0);
    EXPECT_EQ(help.err, "");
    EXPECT_NE(help.out.find("Example:\n  assay "), std::string::npos) << words[0];
    std::istringstream lines(help.out);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80u) << line;
  }
  for (const std::string& verb : verbs)
    EXPECT_NE(call_verb({"--help"}).out.find("\n  " + verb + " "), std::string::npos) << verb;
}

TEST_F(CommandLine, WithoutAVerbItNamesThem) {
  for (const auto& words : std::vector<std::vector<std::string>>{{}, {"--"}, {"--quiet"}}) {
    const VerbOutcome outcome = call_verb(words);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err, "assay: no verb; known: " + joined(verbs_of_help()) + "; assay --help tells more\n");
  }
}

TEST_F(CommandLine, VersionSaysWhatItWasBuiltWith) {
  const VerbOutcome outcome = call_verb({"--version"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_TRUE(outcome.out.starts_with("assay ")) << outcome.out;
  EXPECT_NE(outcome.out.find("\ncompiler  "), std::string::npos);
}

TEST_F(CommandLine, MistypedWordsAreSuggestedFor) {
  const VerbOutcome verb = call_verb({"tabluate", "x"});
  EXPECT_EQ(verb.status, 2);
  EXPECT_EQ(verb.err, "assay: unknown verb 'tabluate' (nearest: tabulate); known: " + joined(verbs_of_help()) + "\n");
  EXPECT_TRUE(
      refused({"--thread=2"}).starts_with("assay run: unknown option '--thread' (nearest: --threads); known: "));
  EXPECT_TRUE(refused({"--sett", "a=1"}).starts_with("assay run: unknown option '--sett' (nearest: --set)"));
  EXPECT_TRUE(refused({"b.yaml"}).starts_with("assay run: unknown argument 'b.yaml'"));
  EXPECT_TRUE(call_verb({"--config", "x"}).err.starts_with("assay: unknown option '--config'; known: "));
  EXPECT_TRUE(call_verb({"--quiet", "x"}).err.starts_with("assay: unknown verb 'x'"));
  EXPECT_TRUE(call_verb({"--quite"}).err.starts_with("assay: unknown option '--quite' (nearest: --quiet)"));
}

TEST_F(CommandLine, EveryUsageErrorIsOneLineAndTwo) {
  const std::vector<std::vector<std::string>> calls{{"run"},
                                                    {"eval", "x"},
                                                    {"explain"},
                                                    {"register"},
                                                    {"run", "x", "--set"},
                                                    {"run", "x", "-o"},
                                                    {"run", "x", "-o", ""},
                                                    {"tabulate", "x", "-o", ""},
                                                    {"eval", "x", "--points", "y", "-o", ""},
                                                    {"register", ""},
                                                    {"schema", "x"},
                                                    {"run", "x", "-o", "a", "-o", "b"},
                                                    {"run", "x", "--threads", "0"},
                                                    {"run", "x", "--threads", "many"},
                                                    {"run", "x", "--threads", "1.5"},
                                                    {"run", "x", "--json=maybe"},
                                                    {"register", "x", "--remove", "y"},
                                                    {""},
                                                    {"-x"},
                                                    {"--"},
                                                    {"run", ""},
                                                    {"run", "/"},
                                                    {"run", "a\nb.yaml"},
                                                    {"materials", "a", "b"},
                                                    {"recommend"},
                                                    {"recommend", "x"},
                                                    {"recommend", "x", "--error", "1"},
                                                    {"compare", "x"},
                                                    {"compare", "x", "y"},
                                                    {"compare", "x", "y", "z"},
                                                    {"compare", "x", "y", "--json", "--markdown", "-"},
                                                    {"materials", "nobody"}};
  for (const auto& words : calls) {
    const VerbOutcome outcome = call_verb(words);
    EXPECT_EQ(outcome.status, 2) << testing::PrintToString(words);
    EXPECT_EQ(outcome.out, "") << testing::PrintToString(words);
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
}

TEST_F(CommandLine, AnOptionIsNoValue) {
  const auto said = [](const std::vector<std::string>& words) {
    const VerbOutcome outcome = call_verb(words);
    EXPECT_EQ(outcome.status, 2) << testing::PrintToString(words);
    EXPECT_EQ(outcome.out, "");
    return outcome.err;
  };
  const std::string scene = write("scene.yaml", scene_text());
  EXPECT_EQ(said({"run", scene, "-o", "--quiet"}),
            "assay run: -o needs a value, and '--quiet' begins like an option; a file of that name is ./--quiet\n");
  EXPECT_EQ(said({"run", scene, "--junit", "-v"}),
            "assay run: --junit needs a value, and '-v' begins like an option; a file of that name is ./-v\n");
  EXPECT_EQ(said({"run", scene, "--junit-name", "clay"}), "assay run: --junit-name goes with --junit\n");
  EXPECT_EQ(said({"check", "j2_jaumann", "--junit-name", "clay"}), "assay check: --junit-name goes with --junit\n");
  EXPECT_EQ(said({"check", "--all", "--junit", "a.xml", "--junit-name", "clay"}),
            "assay check: --junit-name names one suite, and --all writes one for each material\n");
  EXPECT_EQ(
      said({"check", "x.so", "--json", "--junit", "a.xml"}),
      "assay check: --json needs a value, and '--junit' begins like an option; a file of that name is ./--junit\n");
  EXPECT_EQ(
      said({"eval", scene, "--points", "--typo"}),
      "assay eval: --points needs a value, and '--typo' begins like an option; a file of that name is ./--typo\n");
  EXPECT_EQ(said({"run", scene, "-o", "-x"}),
            "assay run: -o needs a value, and '-x' begins like an option; a file of that name is ./-x\n");
  EXPECT_EQ(said({"check", "x.f", "--deck", "-1"}),
            "assay check: --deck needs a value, and '-1' begins like an option; a file of that name is ./-1\n");
  EXPECT_EQ(said({"run", scene, "-o=out/eq"}),
            "assay run: -o takes its value after a space, without '=': write -o out/eq; a file of that name is "
            "./=out/eq\n");
  EXPECT_EQ(said({"run", scene, "-o="}),
            "assay run: -o takes its value after a space, without '=': write -o ...; a file of that name is ./=\n");
  EXPECT_EQ(said({"run", scene, "-o"}), "assay run: -o needs a value\n");
  EXPECT_EQ(said({"run", scene, "--threads", ""}), "assay run: --threads needs a value, but the value is empty\n");
  EXPECT_EQ(said({"study", scene, "--jobs", ""}), "assay study: --jobs needs a value, but the value is empty\n");
  EXPECT_EQ(said({"run", scene, "-o", "a", "-o", "b"}), "assay run: -o is given 2 times, but takes one value\n");
  EXPECT_EQ(said({"check", "x.f", "--json", "a", "--json", "b", "--json", "c"}),
            "assay check: --json is given 3 times, but takes one value\n");
  EXPECT_FALSE(std::filesystem::exists("--quiet"));
  EXPECT_EQ(said({"check", "x.f", "--props", "-1"}).find("needs a value"), std::string::npos) << "a number";
  EXPECT_EQ(said({"check", "x.so", "--strain", "-.5"}).find("needs a value"), std::string::npos) << "a number";
  EXPECT_EQ(said({"check", "x.so", "--json", "-"}).find("needs a value"), std::string::npos) << "standard output";
}

TEST_F(CommandLine, ANameAndItsValueAreOneWord) {
  const std::string scene = write("scene.yaml", scene_text()), begin = "a name and its value are one word with '=' ";
  const std::string set = "--set: " + begin + "between them: write --set ";
  EXPECT_EQ(call_verb({"run", scene, "--set", "frame.angle", "-0.7"}).err, set + "frame.angle=-0.7\n");
  EXPECT_EQ(call_verb({"run", scene, "--set", "grid.spacing", "0.1"}).err, set + "grid.spacing=0.1\n");
  EXPECT_EQ(call_verb({"run", scene, "--set", "grid.spacing", "=0.1"}).err, set + "grid.spacing=0.1\n");
  EXPECT_EQ(call_verb({"run", scene, "--set", "grid.spacing", "=", "0.1"}).err, set + "grid.spacing=...\n");
  EXPECT_EQ(call_verb({"run", scene, "--set", "grid.spacing=", "0.1"}).err, set + "grid.spacing=0.1\n");
  EXPECT_EQ(call_verb({"check", "neo_hookean", "--parameters", "E", "1e3"}).err,
            "--parameters: " + begin + "between them: write --parameters E=1e3\n");
}

TEST_F(CommandLine, AnOptionWithAnotherDashIsNamed) {
  const std::string scene = write("scene.yaml", scene_text());
  for (const auto& [word, meant] : {std::pair{"\u2014set", "--set"}, {"\u2013set", "--set"}, {"\u2212o", "-o"}}) {
    const std::string said = call_verb({"run", scene, word, "grid.spacing=.1"}).err;
    EXPECT_EQ(said.find(std::string("assay run: unknown option '") + word + "'"), 0u) << said;
    EXPECT_NE(said.find(std::string("(nearest: ") + meant + "), U+2"), std::string::npos) << said;
  }
  const std::string before_the_scene = call_verb({"run", "\u2014quiet", scene}).err;
  EXPECT_EQ(before_the_scene.find("assay run: unknown option '\u2014quiet'"), 0u) << before_the_scene;
}

TEST_F(CommandLine, ANameThatBeginsWithAHyphenStandsBehindTwo) {
  const std::string before = std::filesystem::current_path();
  const ScratchFolder scratch;
  std::filesystem::current_path(scratch / "");
  scratch.write("-s.yaml", "motion: 1\n");
  EXPECT_EQ(call_verb({"run", "-s.yaml"}).err, "assay run: unknown option '-s.yaml'; the file is ./-s.yaml\n");
  EXPECT_TRUE(call_verb({"run", "--", "-s.yaml"}).err.starts_with("./-s.yaml:1:9: motion: "))
      << call_verb({"run", "--", "-s.yaml"}).err;
  EXPECT_TRUE(call_verb({"run", "-o", "out", "--", "-s.yaml"}).err.starts_with("./-s.yaml:1:9: motion: "));
  EXPECT_TRUE(call_verb({"check", "--", "-no.f"}).err.find("no such file: '") == 0u);
  std::filesystem::current_path(before);
}

TEST_F(CommandLine, SettingsReachTheReaderAsTheyStand) {
  EXPECT_EQ(refused({"--set", "motion.x=[1,2]"}),
            "--set motion.x: unknown key; known: type, inner, outer, path, interpolation, time_unit, final, center, "
            "strength, vortices, period, profile, radius, ring_radius, height, profile_power, expansion, wave_speed, "
            "factors, stretch, "
            "shear, rotation, velocity, spin, height_power, axis, rotate, allow_unstable, amplitude\n");
  EXPECT_EQ(refused({"--set=motion.inner=[1,2]"}), "--set motion.inner: must be a number, found a list\n");
  EXPECT_EQ(refused({"--set", "[1,2]"}), "--set: takes key.path=value, found '[1,2]'\n");
  EXPECT_TRUE(refused({"--set", "[motion.inner=1,motion.outer=2]"}).starts_with("--set [motion: unknown key"))
      << "not split";
  EXPECT_EQ(refused({"--set", "{}"}), "--set: takes key.path=value, found '{}'\n");
  EXPECT_EQ(refused({"--set", ""}), "--set: takes key.path=value, found ''\n");
  EXPECT_EQ(refused({"--set", "time.end=1", "--set", "time.end=-1"}),
            "--set time.end: must be greater than 0, found '-1'\n");
  EXPECT_TRUE(refused({"--set", "time.end=1", "time.step=1"}).starts_with("assay run: unknown argument 'time.step=1'"))
      << "one argument each";
}

TEST_F(CommandLine, SchemaAndMaterialsPrintOnStandardOutput) {
  const VerbOutcome schema = call_verb({"schema"});
  EXPECT_EQ(schema.status, 0);
  EXPECT_TRUE(schema.out.starts_with("{\n"));
  EXPECT_NE(schema.out.find("\"assay scene\""), std::string::npos);
  EXPECT_NE(call_verb({"schema", "--study"}).out.find("\"assay study\""), std::string::npos);
  EXPECT_EQ(call_verb({"materials", "neo_hookean", "--json"}).out.substr(0, 2), "{\n");
  EXPECT_EQ(call_verb({"materials", "--quiet"}).status, 0);
}

TEST_F(CommandLine, RegistersAndRemoves) {
  EXPECT_EQ(call_verb({"register", plugins + "frozen_1_0.so", "--as", "soft"}).status, 0);
  EXPECT_EQ(call_verb({"materials", "soft"}).status, 0);
  EXPECT_EQ(call_verb({"register", "--remove", "soft", "--quiet"}).status, 0);
  EXPECT_EQ(call_verb({"materials", "soft"}).status, 2);
  write("blocked", "");
  setenv("ASSAY_DATA_HOME", (folder / "blocked").c_str(), 1);
  const VerbOutcome blocked = call_verb({"register", plugins + "frozen_1_0.so"});
  EXPECT_EQ(blocked.status, 3);
  EXPECT_EQ(std::count(blocked.err.begin(), blocked.err.end(), '\n'), 1) << blocked.err;
}

}  // namespace
}  // namespace assay::drivers::test_command_line
