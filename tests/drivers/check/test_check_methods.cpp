// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "drivers/check/methods_report.hpp"
#include "drivers/scene/scene_keys.hpp"
#include "tests/drivers/process.hpp"
#include "tests/support/renewal.hpp"

namespace assay::drivers::test_check_methods {
namespace {

/// All in one test: the methods are what takes the time.
TEST(LongCheckMethods, RunsEveryMethodAndSaysItInJsonJUnitAndTheTableOfTheDocuments) {
  const ScratchFolder scratch;
  const std::string json = scratch / "methods.json", junit = scratch / "methods.xml", table = scratch / "methods.md";
  const Ending ending =
      assay({"check", "--methods", "--quick", "--verbose", "--json", json, "--junit", junit, "--markdown", table});
  EXPECT_EQ(ending.status, 0) << ending.said;
  const auto found = nlohmann::json::parse(bytes_of(json));
  EXPECT_EQ(found["verdict"], "pass");
  ASSERT_EQ(found["methods"].size(), mpm::all_methods().size());
  std::set<std::string> rows, ids;
  for (const auto& test : found["tests"]) {
    for (const char* key : {"method", "basis", "formulation", "transfer", "update", "mass", "id", "verdict", "measure",
                            "threshold", "order", "cause", "sentence"}) {
      EXPECT_TRUE(test.contains(key)) << key;
    }
    EXPECT_NE(test["verdict"], "fail");
    ids.insert(test["id"].get<std::string>());
    rows.insert(test["method"].get<std::string>() + " " + test["id"].get<std::string>());
  }
  EXPECT_EQ(rows.size(), found["tests"].size());
  EXPECT_EQ(rows.size(), found["methods"].size() * ids.size());
  EXPECT_EQ(ids.count("translation"), 1u);
  const std::string xml = bytes_of(junit);
  EXPECT_NE(xml.find("<testsuite name=\"assay check methods\""), std::string::npos);
  EXPECT_NE(xml.find("name=\"cpdi/flip/usl rotation.volume\""), std::string::npos);
  EXPECT_EQ(xml.find("<failure"), std::string::npos);
  EXPECT_NE(xml.find("not promised: "), std::string::npos);
  const std::string markdown = bytes_of(table);
  EXPECT_EQ(markdown.rfind("All " + std::to_string(found["methods"].size()) + " methods pass `", 0), 0u);
  EXPECT_GT(std::count(markdown.begin(), markdown.end(), '\n'), 10);
  expect_table("docs/check.md", "All [0-9]+ methods pass", markdown);

  std::istringstream page(ending.said);
  std::string line, method;
  for (int skipped = 0; skipped < 3; ++skipped) std::getline(page, line);  // verdict, blank line, head of the table
  while (std::getline(page, line) && !line.empty()) {
    if (line.starts_with("    ")) continue;  // a sentence
    if (line[0] != ' ') {
      method = line;
      continue;
    }
    std::istringstream words(line);
    std::string id;
    words >> id;
    EXPECT_EQ(rows.erase(method + " " + id), 1u) << line;
  }
  EXPECT_TRUE(rows.empty());
  EXPECT_NE(ending.said.find("\nn/a  stress.jittered: domains of CPDI"), std::string::npos) << ending.said;
}

/// What takes the time are the methods: one of each kind here, all of them in the tests of mpm with the label long.
TEST(CheckMethods, RunsAMethodInSpaceAndSaysItInJsonJUnitAndMarkdown) {
  const ScratchFolder scratch;
  const std::string json = scratch / "method.json", junit = scratch / "method.xml", table = scratch / "method.md";
  for (const std::string method : {"cpdi2/apic_moment/usl", "bspline2/pic/usf/total"}) {
    const Ending ending = assay(
        {"check", "--methods", method, "--dimension", "3", "--json", json, "--junit", junit, "--markdown", table});
    EXPECT_EQ(ending.status, 0) << ending.said;
    EXPECT_EQ(ending.said.rfind("methods in three dimensions: pass; 1 method, ", 0), 0u) << ending.said;
    const auto found = nlohmann::json::parse(bytes_of(json));
    EXPECT_EQ(found["dimension"], 3);
    EXPECT_EQ(found["verdict"], "pass");
    std::set<std::string> ids;
    for (const auto& test : found["tests"]) ids.insert(test["id"].get<std::string>());
    EXPECT_EQ(ids.size(), 22u);
    for (const char* id : {"slab.x", "slab.z", "tilted.axes", "tilted.strain", "stress.graded", "surface.traction"})
      EXPECT_EQ(ids.count(id), 1u) << id;
    EXPECT_NE(bytes_of(junit).find("<testsuite name=\"assay check methods_3d\""), std::string::npos);
    EXPECT_EQ(bytes_of(table).rfind("In three dimensions, the method passes ", 0), 0u);
    EXPECT_NE(text_of_tree("docs/check.md").find("`tilted.axes`"), std::string::npos);
  }
}

TEST(CheckMethods, ADimensionIsTwoOrThreeAndGoesWithMethods) {
  const Ending plane = assay({"check", "--methods", "linear/pic/usl", "--quick", "--json", "-"}),
               said = assay({"check", "--methods", "linear/pic/usl", "--quick", "--dimension", "2", "--json", "-"});
  EXPECT_EQ(plane.said, said.said);
  EXPECT_FALSE(nlohmann::json::parse(said.said).contains("dimension"));
  const Ending four = assay({"check", "--methods", "--dimension", "4"});
  EXPECT_EQ(four.status, 2);
  EXPECT_EQ(four.said, "--dimension: must be 2 or 3, found '4'\n");
  const Ending model = assay({"check", "neo_hookean", "--dimension", "3"});
  EXPECT_EQ(model.status, 2);
  EXPECT_EQ(model.said, "assay check: --dimension goes with --methods\n");
}

TEST(CheckMethods, WritesJsonAloneOnStandardOutputAndOfOneMethodThatAlone) {
  const Ending ending = assay({"check", "--methods", "cpdi/flip/usl", "--json", "-"});
  EXPECT_EQ(ending.status, 0);
  const auto found = nlohmann::json::parse(ending.said);
  EXPECT_EQ(found["methods"], nlohmann::json({"cpdi/flip/usl"}));
  ASSERT_TRUE(found["tests"].is_array());
  for (const auto& test : found["tests"]) EXPECT_EQ(test["method"], "cpdi/flip/usl");
}

TEST(CheckMethods, AnUnknownMethodNamesTheNearest) {
  const Ending ending = assay({"check", "--methods", "cpdi/flap/usl"});
  EXPECT_EQ(ending.status, 2);
  EXPECT_EQ(
      ending.said,
      "--methods: unknown method 'cpdi/flap/usl' (nearest: cpdi/flip/usl); --methods --verbose prints them all\n");
}

TEST(CheckMethods, MarkdownAloneGoesToStandardOutput) {
  const Ending ending = assay({"check", "--methods", "cpdi/flip/usl", "--quick", "--quiet", "--markdown", "-"});
  EXPECT_EQ(ending.status, 0);
  EXPECT_EQ(ending.said.rfind("The method passes `", 0), 0u) << ending.said;
}

TEST(CheckMethods, MarkdownGoesWithMethodsToAFileOfItsOwn) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"check", "neo_hookean", "--parameters", "E=1", "--quick", "--markdown", "-"},
        {"check", "--methods", "--json", "-", "--markdown", "-"},
        {"check", "--methods", "--junit", "same", "--markdown", "same"}}) {
    const Ending ending = assay(words);
    EXPECT_EQ(ending.status, 2);
    EXPECT_NE(ending.said.find("--markdown"), std::string::npos) << ending.said;
    EXPECT_EQ(std::count(ending.said.begin(), ending.said.end(), '\n'), 1) << ending.said;
  }
}

TEST(CheckMethods, TakesNoMaterial) {
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{"neo_hookean"}, {"--parameters", "E=1"}, {"neo_hookean", "--parameters", "E=1"}}) {
    std::vector<std::string> words{"check", "--methods"};
    words.insert(words.end(), more.begin(), more.end());
    const Ending ending = assay(words);
    EXPECT_EQ(ending.status, 2);
    EXPECT_NE(ending.said.find("--methods"), std::string::npos) << ending.said;
    EXPECT_EQ(std::count(ending.said.begin(), ending.said.end(), '\n'), 1) << ending.said;
  }
}

CheckedMethods broken() {
  mpm::MethodReport report{{}, {}};
  report.tests = {{.id = "weights.unity", .measure = 1e-16, .threshold = 1e-13, .sentence = "fine"},
                  {.id = "rotation.displacement",
                   .verdict = check::Verdict::fail,
                   .measure = INFINITY,
                   .threshold = 0.004,
                   .order = -0.04,
                   .cause = "does <not> fall",
                   .sentence = "unstable & gone"},
                  {.id = "stress.jittered",
                   .verdict = check::Verdict::not_applicable,
                   .measure = 0.48,
                   .sentence = "large; not promised: holes"}};
  return {{report}, 0.5, 2};
}

TEST(MethodsReport, TextFitsEightyColumnsAndShowsWhatFails) {
  EXPECT_FALSE(broken().passes());
  for (const Verbosity verbosity : {Verbosity::quiet, Verbosity::normal, Verbosity::verbose}) {
    const std::string text = methods_text(broken(), verbosity);
    std::istringstream page(text);
    for (std::string line; std::getline(page, line);) EXPECT_LE(line.size(), 80u) << line;
    EXPECT_TRUE(text.starts_with("methods: FAIL; 1 method, 1 test passed, 1 failed, 1 not promised\n")) << text;
    EXPECT_EQ(text.find("unstable & gone") != std::string::npos, verbosity != Verbosity::quiet);
    EXPECT_EQ(text.find("holes") != std::string::npos, verbosity == Verbosity::verbose);
  }
  const std::string text = methods_text(broken(), Verbosity::normal);
  EXPECT_NE(text.find("cpdi/flip/usl\n  weights.unity"), std::string::npos) << text;
  EXPECT_NE(text.find("  rotation.displacement    FAIL     infinite   0.004     0\n"), std::string::npos) << text;
}

TEST(MethodsReport, ManyMethodsAreCountedByBasisAndFailuresShown) {
  CheckedMethods two = broken();
  two.methods.push_back(two.methods.front());
  two.methods.back().method.basis = mpm::Basis::linear;
  const std::string text = methods_text(two, Verbosity::normal), all = methods_text(two, Verbosity::verbose);
  EXPECT_TRUE(text.starts_with("methods: FAIL; 2 methods, 2 tests passed, 2 failed, 2 not promised\n")) << text;
  for (const char* line : {"\n  rotation.displacement    FAIL     infinite   0.004     0\n", "unstable & gone",
                           "\n  cpdi, updated            1        1          1         1\n",
                           "\n  linear, updated          1        1          1         1\n"}) {
    EXPECT_NE(text.find(line), text.npos) << line << text;
  }
  EXPECT_EQ(text.find("weights.unity"), text.npos) << text;
  EXPECT_NE(all.find("  weights.unity"), all.npos) << all;
}

TEST(MethodsReport, SaysInHowManyDimensions) {
  CheckedMethods space = broken();
  space.dimension = 3;
  EXPECT_TRUE(methods_text(space, Verbosity::quiet).starts_with("methods in three dimensions: FAIL; 1 method, "));
  EXPECT_TRUE(methods_markdown(space).starts_with("In three dimensions, the method passes `weights.unity`."));
  EXPECT_EQ(nlohmann::json::parse(methods_json(space))["dimension"], 3);
  EXPECT_FALSE(nlohmann::json::parse(methods_json(broken())).contains("dimension"));
}

TEST(MethodsReport, JsonNamesChoicesByTheWordsThatAScenesKeysTake) {
  CheckedMethods all;
  for (const mpm::Method& method : mpm::all_methods()) all.methods.push_back({method, {{.id = "translation"}}});
  const auto found = nlohmann::json::parse(methods_json(all));
  ASSERT_EQ(found["tests"].size(), mpm::all_methods().size());
  for (const char* choice : {"basis", "formulation", "transfer", "update", "mass"}) {
    const auto key = std::find_if(scene_keys().begin(), scene_keys().end(),
                                  [&](const Key& each) { return each.path == "method." + std::string(choice); });
    ASSERT_NE(key, scene_keys().end()) << choice;
    std::set<std::string> said;
    for (const auto& test : found["tests"]) said.insert(test[choice].get<std::string>());
    EXPECT_EQ(said, std::set<std::string>(key->choices.begin(), key->choices.end())) << choice;
  }
}

TEST(MethodsReport, JsonHasNoNumberForWhatIsInfiniteAndJUnitNamesTheCause) {
  const auto found = nlohmann::json::parse(methods_json(broken()));
  EXPECT_EQ(found["verdict"], "fail");
  EXPECT_TRUE(found["tests"][1]["measure"].is_null());
  EXPECT_EQ(found["tests"][1]["cause"], "does <not> fall");
  EXPECT_EQ(found["tests"][2]["verdict"], "n/a");
  EXPECT_EQ(found["tests"][2]["measure"], 0.48);
  EXPECT_EQ(found["tests"][0]["formulation"], "updated");
  EXPECT_EQ(found["tests"][0]["mass"], "lumped");
  const std::string xml = methods_junit(broken());
  EXPECT_NE(xml.find("tests=\"3\" failures=\"1\" errors=\"0\" skipped=\"1\" time=\"0.500\""), std::string::npos) << xml;
  EXPECT_NE(xml.find("<failure message=\"does &lt;not&gt; fall: unstable &amp; gone\""), std::string::npos) << xml;
}

}  // namespace
}  // namespace assay::drivers::test_check_methods
