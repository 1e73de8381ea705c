// SPDX-License-Identifier: BSD-3-Clause
// Version, man page and scenes agree with the program.
#include <gtest/gtest.h>

#include <regex>

#include "drivers/result/result.hpp"
#include "tests/house/tree.hpp"
#include "tests/support/built.hpp"
#include "tests/support/renewal.hpp"

namespace assay::test_documents {
namespace {

using namespace assay::house;

/// The text of the man page that the build makes, without its font changes and escaped hyphens.
std::string man_page() {
  const std::string text = std::regex_replace(text_of(built("assay.1")), std::regex(R"(\\f[A-Z])"), "");
  return std::regex_replace(text, std::regex(R"(\\-)"), "-");
}

/// What `assay --help` and the help of every verb print.
std::string all_help() {
  std::string help = run_assay("--help").output;
  for (const std::string& verb : verbs()) help += run_assay(verb + " --help").output;
  return help;
}

bool has_word(const std::string& text, const std::string& word) {
  return std::regex_search(text, std::regex("(^|[^A-Za-z0-9_-])" + word + "($|[^A-Za-z0-9_-])"));
}

TEST(Documents, VersionIsTheSameEverywhere) {
  const std::string version = ASSAY_VERSION;
  EXPECT_EQ(assay::drivers::build_information().version, version);
  EXPECT_TRUE(has_word(run_assay("--version").output, std::regex_replace(version, std::regex("\\."), "\\.")));

  std::smatch match;
  const std::string changes = text_of("CHANGELOG.md");
  ASSERT_TRUE(std::regex_search(changes, match, std::regex(R"(## \[?([0-9]+\.[0-9]+\.[0-9]+))")));
  EXPECT_EQ(match[1], version);
  const std::string man = text_of("docs/assay.1");
  ASSERT_TRUE(std::regex_search(man, match, std::regex(R"re(\.TH ASSAY 1 "[^"]*" "assay ([0-9.]+)")re")));
  EXPECT_EQ(match[1], version);
  const std::string recipes = text_of("docs/clusters.md");
  const std::regex named("assay[_:](\\d+\\.\\d+\\.\\d+)");
  std::sregex_iterator each(recipes.begin(), recipes.end(), named), end;
  EXPECT_NE(each, end);
  for (; each != end; ++each) EXPECT_EQ((*each)[1], version) << "docs/clusters.md";
}

TEST(Documents, BuildInformationIsComplete) {
  const auto found = assay::drivers::build_information();
  EXPECT_FALSE(found.git.empty());
  EXPECT_TRUE(std::regex_search(found.compiler, std::regex("[A-Za-z]+ [0-9]+\\."))) << found.compiler;
  EXPECT_NE(found.flags.find("-ffp-contract=off"), std::string::npos) << found.flags;
  EXPECT_EQ(found.flags.find("-march=native"), std::string::npos) << "the binary is to run on every x86-64";
  ASSERT_GE(found.libraries.size(), 7u);
  for (const auto& library : found.libraries) {
    EXPECT_TRUE(std::regex_match(library, std::regex("[A-Za-z0-9_-]+ [0-9]+(\\.[0-9]+)*"))) << library;
  }
  EXPECT_TRUE(found.scene_sha256.empty());
}

TEST(Documents, ManPageKnowsEveryVerb) {
  const auto known = verbs();
  ASSERT_GE(known.size(), 7u) << "no verbs found in `assay --help`";
  const std::string man = man_page();
  for (const std::string& verb : known) EXPECT_TRUE(has_word(man, ".SS assay " + verb)) << verb;
}

TEST(LongDocuments, ManPageKnowsEveryOption) {
  const std::string help = all_help(), man = man_page();
  const std::regex option("--[a-z][a-z-]+");
  int seen = 0;
  for (std::sregex_iterator it(help.begin(), help.end(), option), end; it != end; ++it, ++seen) {
    EXPECT_TRUE(has_word(man, it->str())) << it->str();
  }
  EXPECT_GT(seen, 10);
}

// Nor does it promise options that the program does not have.
TEST(LongDocuments, ManPagePromisesNothingMore) {
  const std::string help = all_help(), man = man_page();
  const std::regex option("--[a-z][a-z-]+");
  for (std::sregex_iterator it(man.begin(), man.end(), option), end; it != end; ++it) {
    EXPECT_TRUE(has_word(help, it->str())) << it->str();
  }
}

TEST(Documents, EverySceneSaysWhatItExpects) {
  const auto scenes = files_in("configs", {".yaml", ".yml"}, true);
  EXPECT_FALSE(scenes.empty());
  for (const std::string& path : scenes) {
    EXPECT_TRUE(std::regex_search("\n" + text_of(path), std::regex("\nexpect:"))) << path;
  }
}

/// The line by which an editor finds the schema of a file of configs/, from the file's own folder.
std::string line_for_editors(const std::string& path) {
  std::string up;
  for (std::size_t at = path.find('/'); (at = path.find('/', at + 1)) != path.npos;) up += "../";
  const bool study = path.starts_with("configs/studies/"), of_point = path.starts_with("configs/paths/");
  const char* kind = study ? "study" : of_point ? "path" : "scene";
  return "# yaml-language-server: $schema=" + up + "schema/" + kind + ".schema.json";
}

TEST(Documents, EverySceneBeginsWithTheLineForEditors) {
  EXPECT_EQ(line_for_editors("configs/a/b.yaml"), "# yaml-language-server: $schema=../schema/scene.schema.json");
  EXPECT_EQ(line_for_editors("configs/studies/b.yaml"), "# yaml-language-server: $schema=../schema/study.schema.json");
  EXPECT_EQ(line_for_editors("configs/paths/b.yaml"), "# yaml-language-server: $schema=../schema/path.schema.json");
  for (const std::string& path : files_in("configs", {".yaml", ".yml"}, true)) {
    EXPECT_EQ(lines_of(text_of(path)).at(0), line_for_editors(path)) << path;
  }
}

TEST(Documents, SchemasBesideTheScenesAreThoseOfTheProgram) {
  expect_file("configs/schema/scene.schema.json", run_assay("schema").output);
  expect_file("configs/schema/study.schema.json", run_assay("schema --study").output);
  expect_file("configs/schema/path.schema.json", run_assay("schema --path").output);
}

}  // namespace
}  // namespace assay::test_documents
