// SPDX-License-Identifier: BSD-3-Clause
// What CI runs: the table of stages is that of `dev`, and the suites that are watched by the sanitizers exist.
#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "tests/house/tree.hpp"

namespace assay::test_stages {
namespace {

using namespace assay::house;

std::set<std::string> words_of(const std::string& text) {
  std::istringstream in(text);
  std::set<std::string> words;
  for (std::string word; in >> word;) words.insert(word);
  return words;
}

/// The stages of a line NAME='a b c' of `dev`.
std::set<std::string> stages_of(const std::string& name) {
  std::smatch found;
  const std::string dev = text_of("dev");
  EXPECT_TRUE(std::regex_search(dev, found, std::regex("\n" + name + "='([a-z ]+)'\n"))) << name;
  return found.empty() ? std::set<std::string>{} : words_of(found[1]);
}

/// The first column of the rows of development.md whose last column is `when`.
std::set<std::string> rows_of(const std::string& when) {
  std::set<std::string> names;
  std::smatch row;
  for (const std::string& line : lines_of(text_of("docs/development.md"))) {
    if (std::regex_match(line, row, std::regex("\\| ([a-z]+) \\|.*\\| " + when + " \\|[^|]*\\|"))) names.insert(row[1]);
  }
  return names;
}

TEST(Stages, TheTableIsThatOfDev) {
  EXPECT_EQ(rows_of("every change"), stages_of("every_change"));
  EXPECT_EQ(rows_of("deep"), stages_of("deep_alone"));
  EXPECT_TRUE(stages_of("every_change").contains("tests"));
}

TEST(Stages, EachIsRunByDev) {
  const std::string dev = text_of("dev");
  for (const char* list : {"every_change", "deep_alone"}) {
    for (const std::string& name : stages_of(list)) {
      EXPECT_NE(dev.find("\n  stage " + name + " "), dev.find("\n    stage " + name + " ")) << name;
    }
  }
}

std::set<std::string> suites_in(const std::vector<std::string>& folders) {
  const std::regex test(R"((?:^|\n)(?:TEST|TEST_F|TEST_P|TYPED_TEST)\((\w+))");
  std::set<std::string> suites;
  for (const std::string& folder : folders) {
    for (const std::string& path : files_in(folder, {".cpp"}, true)) {
      const std::string text = text_of(path);
      for (auto found = std::sregex_iterator(text.begin(), text.end(), test); found != std::sregex_iterator();
           ++found) {
        suites.insert((*found)[1]);
      }
    }
  }
  return suites;
}

TEST(Stages, WatchedSuitesExist) {
  const std::string text = std::regex_replace(text_of("tests/sanitized.cmake"), std::regex("#.*"), "");
  const std::regex list(R"(set\(watched_by_test_(\w+)([^)]*)\))");
  std::size_t lists = 0;
  for (auto found = std::sregex_iterator(text.begin(), text.end(), list); found != std::sregex_iterator(); ++found) {
    const std::string program = (*found)[1];
    const std::string folder = program == "library"                               ? "tests/drivers/library"
                               : program == "fuzz_corpus" || program == "mutants" ? "tests/fuzz"
                                                                                  : "tests/" + program;
    const std::set<std::string> suites = suites_in({folder});
    for (const std::string& suite : words_of((*found)[2])) {
      if (suite == "\"\"") continue;
      EXPECT_TRUE(suites.contains(suite))
          << "tests/sanitized.cmake names a suite " << suite << ", which " << folder << " does not have";
    }
    ++lists;
  }
  EXPECT_EQ(lists, 8U);
}

}  // namespace
}  // namespace assay::test_stages
