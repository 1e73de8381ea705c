// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "drivers/check/check_material.hpp"
#include "drivers/check/check_report.hpp"
#include "drivers/system/input_file.hpp"
#include "tests/drivers/process.hpp"
#include "tests/drivers/refusal.hpp"
#include "tests/drivers/scratch_folder.hpp"
#include "tests/support/built.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_check {
namespace {

const std::string plugins = built("tests/plugins/"), broken_model = plugins + "unturned.so";

CheckedMaterial broken();

/// `assay check` with these words; what it prints goes to a file of the scratch folder.
int checked(const std::vector<std::string>& words, std::string* said = nullptr) {
  std::vector<std::string> all{"check"};
  all.insert(all.end(), words.begin(), words.end());
  const Ending ending = assay(all);
  if (said) *said = ending.said;
  return ending.status;
}

TEST(Check, PassesABuiltInModelAndSaysItInJsonAndJUnit) {
  const ScratchFolder scratch;
  const std::string json = scratch / "check.json", junit = scratch / "check.xml";
  EXPECT_EQ(
      checked({"zener", "--parameters", "E=1e3,relaxation_time=0.5", "--quick", "--json", json, "--junit", junit}), 0);
  const auto found = nlohmann::json::parse(read_bytes(json));
  EXPECT_EQ(found["material"], "zener");
  EXPECT_EQ(found["verdict"], "pass");
  EXPECT_EQ(found["parameters"]["E"], 1e3);
  EXPECT_TRUE(found["diagnosis"].empty());
  std::set<std::string> ids;
  for (const auto& test : found["tests"]) {
    ids.insert(test["id"].get<std::string>());
    for (const char* key : {"verdict", "measure", "threshold", "order", "cause"})
      EXPECT_TRUE(test.contains(key)) << key;
    EXPECT_TRUE(test["cause"].is_null());
  }
  EXPECT_EQ(ids.count("rotation.during"), 1u);
  const std::string xml = read_bytes(junit);
  EXPECT_NE(xml.find("<testsuite name=\"assay check zener\""), std::string::npos) << xml;
  EXPECT_NE(xml.find("name=\"rotation.during\""), std::string::npos);
  EXPECT_EQ(xml.find("<failure"), std::string::npos);
}

TEST(LongCheck, TakesSceneDescriptionAndLibrary) {
  const ScratchFolder scratch;
  EXPECT_EQ(checked({tree_folder() + "/configs/paper/vortex_cpdi.yaml", "--quick"}), 0);
  const std::string description = scratch.write("clay.yaml", "library: " + plugins + "frozen_1_0.so\n");
  for (const std::string& material : {plugins + "frozen_1_0.so", description}) {
    std::string said;
    EXPECT_NE(checked({material, "--quick"}, &said), 2) << said;
  }
}

TEST(Check, WhatIsRequiredAndNotGivenIsThatOfTheExample) {
  const ScratchFolder scratch;
  const std::string json = scratch / "check.json", junit = scratch / "check.xml";
  std::string said;
  EXPECT_EQ(checked({"mooney_rivlin", "--quick", "--parameters", "bulk_modulus=900", "--json", json, "--junit", junit},
                    &said),
            0);
  EXPECT_NE(said.find("required parameters that were not given, from the model's example: "), std::string::npos)
      << said;
  EXPECT_NE(said.find("c10 = 120"), std::string::npos) << said;
  const auto found = nlohmann::json::parse(read_bytes(json));
  EXPECT_EQ(found["parameters"]["bulk_modulus"], 900);
  EXPECT_EQ(found["parameters_of_example"], nlohmann::json::array({"c10"}));
  EXPECT_NE(read_bytes(junit).find("<property name=\"parameters of the example\" value=\"c10\"/>"), std::string::npos)
      << read_bytes(junit);
}

/// The file is what readers of JUnit files ask for (tests/drivers/junit.rng).
void expect_junit(const std::string& file) {
  if (std::system("xmllint --version > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "xmllint is not installed (libxml2-utils): JUnit files are not validated";
  const std::string command = "xmllint --noout --relaxng '" + tree_folder() + "/tests/drivers/junit.rng' '" + file +
                              "' > '" + file + ".said' 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << read_bytes(file + ".said") << read_bytes(file);
}

/// The battery stands in another folder; the vortex, which comes last, asks for the material again.
TEST(LongCheck, ARelativePathIsThatOfWhoAsks) {
  const ScratchFolder scratch;
  const Ending ending = assay({"check", "./libneo_hookean.so", "--parameters", "E=1e3", "-o", scratch / "check"},
                              [] { [[maybe_unused]] const int moved = ::chdir(built("materials").c_str()); });
  EXPECT_EQ(ending.status, 0) << ending.said;
}

TEST(LongCheck, JUnitIsValid) {
  const ScratchFolder scratch;
  const std::string good = scratch / "good.xml", bad = scratch / "bad.xml", all = scratch / "all.xml";
  EXPECT_EQ(checked({"neo_hookean", "--parameters", "E=1e3", "--quick", "--junit", good}), 0);
  expect_junit(good);
  EXPECT_EQ(checked({broken_model, "--quick", "--junit", bad, "-o", scratch / "replays"}), 1);
  expect_junit(bad);
  EXPECT_EQ(checked({"--all", "--quick", "--junit", all}), 0);
  expect_junit(all);
  CheckedMaterial odd = broken();
  odd.name = "a <\"&'> name";
  odd.error = "no such & thing";
  expect_junit(scratch.write("odd.xml", check_junit({odd, broken()})));
}

TEST(LongCheck, AllChecksWhatIsRegisteredAndWhatCannotBeChecked) {
  const ScratchFolder scratch;
  const std::string json = scratch / "all.json";
  EXPECT_EQ(checked({"--all", "--quick", "--json", json}), 0);
  const auto found = nlohmann::json::parse(read_bytes(json));
  EXPECT_EQ(found["verdict"], "pass");
  EXPECT_GE(found["materials"].size(), 15u);
  // A value that a model refuses is that model's affair alone
  std::string said;
  EXPECT_EQ(checked({"--all", "--quick", "--parameters", "nu=0.7"}, &said), 2);
  EXPECT_NE(said.find("mooney_rivlin             pass"), std::string::npos) << said;
  EXPECT_NE(said.find("neo_hookean               error"), std::string::npos) << said;
}

TEST(LongCheck, AFailureLeavesAReplayThatFailsAgain) {
  const ScratchFolder scratch;
  const std::string json = scratch / "check.json", replays = scratch / "replays";
  EXPECT_EQ(checked({broken_model, "--quick", "--strain", "0.1", "--step", "0.5", "--json", json, "-o", replays}), 1);
  int failures = 0;
  const auto found = nlohmann::json::parse(read_bytes(json));
  for (const auto& test : found["tests"]) {
    if (test["verdict"] != "fail") continue;
    ++failures;
    const std::string file = test["replay"];
    std::string said;
    EXPECT_EQ(checked({"--replay", file}, &said), 1) << said;
    EXPECT_NE(said.find("the failure was: "), std::string::npos);
    EXPECT_NE(said.find(test["id"].get<std::string>()), std::string::npos) << said;
    // The test makes the calls before the step again; the file's first line says whether it has a step.
    EXPECT_EQ(said.find("needs earlier calls"), std::string::npos) << said;
    const std::string text = read_bytes(file);
    EXPECT_EQ(text.starts_with("# A step that a material failed: F0 "), text.find("\nF0: ") != text.npos) << text;
    EXPECT_NE(text.starts_with("# A step"), text.starts_with("# A test")) << text;
  }
  EXPECT_GT(failures, 0);
  // The model, cured, does not fail any more
  const std::string cured =
      scratch.write("cured.yaml",
                    "material: neo_hookean\nparameters: {E: 1000, nu: 0.3}\nlibrary_sha256: null\n"
                    "test: rotation.during\nquick: true\nreason: once\n");
  EXPECT_EQ(checked({"--replay", cured}), 0);
}

TEST(LongCheck, AModelThatEndsTheProcessIsAFinding) {
  const ScratchFolder scratch;
  for (const char* how : {"exits", "crashes"}) {
    const std::string json = scratch / (std::string(how) + ".json");
    EXPECT_EQ(checked({plugins + how + ".so", "--json", json, "-o", scratch / "replays"}), 1) << how;
    const auto found = nlohmann::json::parse(read_bytes(json));
    EXPECT_EQ(found["verdict"], "fail");
    EXPECT_TRUE(found["diagnosis"][0]["cause"] == "ends the process" || found["diagnosis"][0]["cause"] == "overrun");
    std::string said;
    EXPECT_EQ(checked({"--replay", found["tests"][0]["replay"]}, &said), 1) << said;
  }
}

#if defined(__x86_64__)
TEST(LongCheck, AModelThatDiesOfArraysThatAreNotAlignedIsToldSo) {
  const ScratchFolder scratch;
  for (const char* model : {"loads", "stores"}) {
    const std::string json = scratch / (std::string(model) + ".json");
    EXPECT_EQ(checked({plugins + "aligned.so:" + model, "--quick", "--json", json, "-o", scratch / "r"}), 1) << model;
    const auto found = nlohmann::json::parse(read_bytes(json));
    ASSERT_EQ(found["diagnosis"].size(), 1u);
    EXPECT_EQ(found["diagnosis"][0]["cause"], "depends on alignment");
    EXPECT_NE(found["diagnosis"][0]["sentence"].dump().find("multiples of 8 are all"), std::string::npos);
    EXPECT_EQ(checked({"--replay", found["tests"][0]["replay"]}), 1) << model;
  }
}

/// What dies wherever its arrays are has the old cause.
TEST(Check, AModelThatDiesWhereverItsArraysAreIsNotToldOfAlignment) {
  const ScratchFolder scratch;
  const std::string json = scratch / "check.json";
  EXPECT_EQ(checked({plugins + "crashes.so", "--quick", "--json", json, "-o", scratch / "r"}), 1);
  EXPECT_NE(nlohmann::json::parse(read_bytes(json))["diagnosis"][0]["cause"], "depends on alignment");
}
#endif

#if defined(__x86_64__)
/// What -ffast-math does when a library is loaded is put right; what a call does is the model's own.
TEST(Check, FlushToZeroIsADefectOfCallsAndNotOfLoading) {
  const ScratchFolder scratch;
  const std::string json = scratch / "check.json", parameters = "E=1e3,nu=0.3",
                    library = plugins + "flushes_when_loaded.so";
  EXPECT_EQ(checked({library + ":neo_hookean", "--parameters", parameters, "--quick", "-o", scratch / "r"}), 0);
  EXPECT_EQ(checked({library + ":flushes", "--parameters", parameters, "--quick", "--json", json, "-o", scratch / "r"}),
            1);
  const auto found = nlohmann::json::parse(read_bytes(json));
  ASSERT_EQ(found["diagnosis"].size(), 1u);
  EXPECT_EQ(found["diagnosis"][0]["cause"], "disturbs its process");
  EXPECT_EQ(found["diagnosis"][0]["sentence"], "the model leaves denormal numbers flushed to zero");
}
#endif

/// The verdict is told first, whatever becomes of the files.
TEST(Check, ANativeModelThatPrintsDisturbsItsProcess) {
  const ScratchFolder scratch;
  const std::string json = scratch / "check.json";
  EXPECT_EQ(
      checked({plugins + "prints.so", "--parameters", "E=1e3,nu=0.3", "--quick", "--json", json, "-o", scratch / "r"}),
      1);
  const auto found = nlohmann::json::parse(read_bytes(json));
  ASSERT_EQ(found["diagnosis"].size(), 1u);
  EXPECT_EQ(found["diagnosis"][0]["cause"], "disturbs its process");
  EXPECT_NE(found["diagnosis"][0]["sentence"].dump().find("which is all very well"), std::string::npos);
  EXPECT_EQ(checked({"--replay", scratch / "r/prints.calls.process.yaml"}), 1);
}

TEST(Check, ALittlePrintIsARemarkAndThatOfForeignModelsIsTheirs) {
  CheckedMaterial quiet, foreign;
  quiet.report.tests = {{.id = process_test, .sentence = "as it was"}};
  quiet.printed = "F is not a number";
  quiet.printed_bytes = quiet.printed.size();
  judge_printing(quiet);
  EXPECT_TRUE(quiet.passes());
  EXPECT_EQ(quiet.report.tests[0].sentence,
            "as it was; a remark: the model prints: 17 bytes, the last line \"F is not a number\"");
  const ScratchFolder scratch;
  const std::string description =
      scratch.write("u.yaml", "library: u.so\ninterface: umat\ndensity: 1000\nproperties: {E: 1.0e3, nu: 0.3}\n");
  foreign.description = description;
  foreign.report.tests = {{.id = process_test, .sentence = "as it was"}};
  foreign.printed_bytes = 1 << 20;
  judge_printing(foreign);
  EXPECT_EQ(foreign.report.tests[0].sentence, "as it was");
}

TEST(LongCheck, AnUnwritablePlaceCostsNoVerdict) {
  for (const std::vector<std::string>& place :
       std::vector<std::vector<std::string>>{{"-o", "/proc/x"}, {"--json", "/proc/x"}, {"--junit", "/proc/x"}}) {
    std::vector<std::string> words{broken_model, "--quick", "-o", "/proc/y"};
    words.resize(place[0] == "-o" ? 2 : 4);
    words.insert(words.end(), place.begin(), place.end());
    std::string said;
    EXPECT_EQ(checked(words, &said), 3) << place[0];
    EXPECT_NE(said.find("diagnosis: increment rotation missing"), std::string::npos) << said;
    EXPECT_NE(said.find("/proc"), std::string::npos) << said;
  }
}

/// Those of a failure that is cured go; those of another material stay.
TEST(Check, ReplayFilesAreOfTheLastCheck) {
  const ScratchFolder scratch;
  const std::string replays = scratch / "replays", stale = replays + "/neo_hookean.rotation.during.yaml",
                    other = replays + "/clay.rotation.during.yaml";
  std::filesystem::create_directories(replays);
  for (const std::string& file : {stale, other}) std::ofstream(file) << "old\n";
  EXPECT_EQ(checked({"neo_hookean", "--parameters", "E=1", "--quick", "-o", replays}), 0);
  EXPECT_FALSE(std::filesystem::exists(stale));
  EXPECT_TRUE(std::filesystem::exists(other));
}

TEST(LongCheck, RefusesBadInputInOneLine) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{plugins + "anisotropic.so"}, "modulus"},
      {{"neo_hookeen"}, "neo_hookean"},
      {{"neo_hookean", "--parameters", "E"}, "NAME=NUMBER"},
      {{"neo_hookean", "--parameters", "E=1,E=2"}, "twice"},
      {{"neo_hookean", "--parameters", "F=1"}, "F"},
      {{"neo_hookean", "--parameters", "E=1,"}, "NAME=NUMBER"},
      {{"neo_hookean", "--parameters", "E=1", "--json", "-", "--junit", "-"}, "--junit"},
      {{"--all", "--quick", "--parameters", "Q=1"}, "Q"},
      {{"--all", "neo_hookean"}, "takes one of"},
      {{}, "MATERIAL"}};
  for (const auto& [words, part] : cases) {
    std::string said;
    EXPECT_EQ(checked(words, &said), 2) << part;
    EXPECT_NE(said.find(part), std::string::npos) << said;
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
  }
}

CheckedMaterial broken() {
  CheckedMaterial checked{"clay", "", {{"E", 1e3}}, {}, 0.25, "clay"};
  checked.report.tests = {{.id = "rest", .measure = 0.0, .threshold = 1e-9, .sentence = "nothing"},
                          {.id = "rotation.fixed_stretch",
                           .verdict = check::Verdict::fail,
                           .measure = 0.15,
                           .threshold = 2e-5,
                           .cause = check::causes::rotation_missing,
                           .sentence = "the stress <stays> & \"waits\""},
                          {.id = "tangent", .verdict = check::Verdict::not_applicable, .sentence = "none is offered"}};
  checked.report.diagnosis = {{check::causes::rotation_missing, "the stress <stays> & \"waits\""}};
  return checked;
}

TEST(CheckReport, JUnitShowsTheCauseInTheMessage) {
  const std::string xml = check_junit({broken()});
  EXPECT_NE(xml.find("tests=\"3\" failures=\"1\" errors=\"0\" skipped=\"1\" time=\"0.250\">"), std::string::npos)
      << xml;
  EXPECT_NE(xml.find("skipped=\"1\""), std::string::npos);
  EXPECT_NE(xml.find("<failure message=\"increment rotation missing: the stress &lt;stays&gt; &amp; "
                     "&quot;waits&quot;\" type=\"increment rotation missing\">increment rotation missing: the stress "
                     "&lt;stays&gt; &amp; &quot;waits&quot;\nmeasured 0.15, at most 2e-05"),
            std::string::npos)
      << xml;
  EXPECT_NE(xml.find("<skipped message=\"none is offered\"/>"), std::string::npos);
}

TEST(CheckReport, ASuiteTakesTheNameThatIsGiven) {
  const std::string own = check_junit({broken()}), named = check_junit({broken()}, "clay.coarse");
  EXPECT_NE(own.find("<testsuite name=\"assay check clay\""), std::string::npos) << own;
  EXPECT_NE(named.find("<testsuite name=\"assay check clay.coarse\""), std::string::npos) << named;
  EXPECT_NE(named.find("<testcase classname=\"assay.check.clay.coarse\""), std::string::npos) << named;
  EXPECT_EQ(named.find("classname=\"assay.check.clay\""), std::string::npos) << named;
}

TEST(CheckReport, TextFitsEightyColumnsAndBeginsWithVerdictAndCause) {
  for (const Verbosity verbosity : {Verbosity::quiet, Verbosity::normal, Verbosity::verbose}) {
    for (const Rows rows : {Rows::all, Rows::telling}) {
      const std::string text = check_text(broken(), verbosity, rows);
      std::istringstream page(text);
      for (std::string line; std::getline(page, line);) EXPECT_LE(line.size(), 80u) << line;
      EXPECT_EQ(text.find("clay: FAIL; "), 0u) << text;
      const std::size_t cause = text.find("\ndiagnosis: increment rotation missing\n"), table = text.find("\ntest ");
      EXPECT_NE(text.find("\n    more: assay check --explain \"increment rotation missing\"\n"), text.npos) << text;
      EXPECT_EQ(table == text.npos, verbosity == Verbosity::quiet);
      EXPECT_LT(cause, table) << text;
    }
  }
  EXPECT_EQ(check_text(broken(), Verbosity::quiet).find("rest"), std::string::npos);
}

TEST(CheckReport, OnATerminalOnlyFailuresAndRemarksHaveARow) {
  const std::string text = check_text(broken(), Verbosity::normal, Rows::telling);
  EXPECT_EQ(text.find("\nrest "), text.npos) << text;
  EXPECT_NE(text.find("FAIL  "), text.npos) << text;
  EXPECT_NE(text.find("\n(2 others: --verbose)\n"), text.npos) << text;
  EXPECT_NE(check_text(broken(), Verbosity::verbose, Rows::telling).find("\nrest "), text.npos);
  CheckedMaterial good;
  good.report.tests = {{.id = "rest", .sentence = "no stress at rest"}};
  EXPECT_EQ(check_text(good, Verbosity::normal, Rows::telling).find("\ntest "), text.npos) << "a table without rows";
}

TEST(CheckReport, ARemarkIsShownWhereItsTestPasses) {
  CheckedMaterial checked;
  checked.report.tests = {{.id = "dissipation", .sentence = "work is lost; a remark: no potential"},
                          {.id = "rest", .sentence = "no stress at rest"}};
  const std::string page = check_text(checked, Verbosity::normal);
  EXPECT_NE(page.find("\n    a remark: no potential\n"), std::string::npos) << page;
  EXPECT_EQ(page.find("no stress at rest"), std::string::npos) << page;
}

TEST(CheckReport, JsonHasNoNumberForWhatIsInfinite) {
  CheckedMaterial checked = broken();
  checked.report.tests[1].measure = INFINITY;
  const auto found = nlohmann::json::parse(check_json(checked));
  EXPECT_EQ(found["verdict"], "fail");
  EXPECT_TRUE(found["tests"][1]["measure"].is_null());
  EXPECT_EQ(found["tests"][1]["cause"], "increment rotation missing");
  EXPECT_EQ(found["tests"][2]["verdict"], "n/a");
  EXPECT_EQ(found["diagnosis"][0]["cause"], "increment rotation missing");
}

}  // namespace
}  // namespace assay::drivers::test_check
