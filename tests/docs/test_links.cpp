// SPDX-License-Identifier: BSD-3-Clause
// Every file, function and test that a page names exists, and every link leads somewhere.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>

#include "tests/docs/page.hpp"
#include "tests/house/tree.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::test_links {
namespace {

namespace fs = std::filesystem;
using namespace assay;

const fs::path root = tree_folder();

/// What is wrong with a relative link; empty: nothing.
std::string defect_of(const docs::Page& page, const docs::Link& link) {
  if (std::regex_search(link.target, std::regex("^(https?|mailto):"))) return {};
  const std::size_t hash = link.target.find('#');
  const std::string file = link.target.substr(0, hash);
  const fs::path path = file.empty() ? fs::path(page.path) : fs::path(page.path).parent_path() / file;
  if (!fs::exists(root / path)) return "no such file";
  if (hash == link.target.npos) return {};
  const std::string normal = path.lexically_normal().string();
  static std::map<std::string, std::vector<std::string>> known;
  if (!known.contains(normal)) known[normal] = docs::parse_page(normal, house::text_of(normal)).anchors;
  const auto& anchors = known[normal];
  const bool found = std::find(anchors.begin(), anchors.end(), link.target.substr(hash + 1)) != anchors.end();
  return found ? "" : "no such heading";
}

/// The names of all tests as `Suite.Test`.
const std::set<std::string>& tests() {
  static const std::set<std::string> found = [] {
    static const std::regex form(R"((?:TYPED_)?TEST(?:_[FP])?\((\w+), (\w+)\))");
    std::set<std::string> names;
    for (const std::string& path : house::files_in("tests", {".cpp"}, true)) {
      const std::string text = house::text_of(path);
      for (std::sregex_iterator it(text.begin(), text.end(), form), end; it != end; ++it) {
        names.insert((*it)[1].str() + "." + (*it)[2].str());
      }
    }
    return names;
  }();
  return found;
}

/// What is wrong with a word in backticks that is a path (`mpm/basis/basis.hpp`, `harness/sheet/sheet.cpp:isochrone`,
/// where the file must hold the name) or the name of a test (`Suite.Test`); empty: nothing, or it is neither.
std::string defect_of(const std::string& word) {
  static const std::regex path_form(
      R"(((?:harness|adapters|mpm|drivers|tests|configs|bench|docs|cmake|completions|\.ci)/[\w./-]*)(?::(\w+))?)");
  static const std::regex test_form(R"([A-Z][A-Za-z0-9]+\.[A-Z][A-Za-z0-9]+)");
  std::smatch match;
  if (std::regex_match(word, match, test_form)) return tests().contains(word) ? "" : "no such test";
  if (!std::regex_match(word, match, path_form)) return {};
  if (word.find("foo") != word.npos || word.find("NAME") != word.npos) return {};  // placeholders
  const fs::path path = match[1].str();
  if (!fs::exists(root / path)) return "no such file";
  if (!match[2].matched) return {};
  const bool named = std::regex_search(house::text_of(path.string()), std::regex("\\b" + match[2].str() + "\\b"));
  return named ? "" : "the file does not hold this name";
}

/// Lines without the blanks at their beginnings.
std::vector<std::string> outdented(const std::string& text) {
  std::vector<std::string> lines = house::lines_of(text);
  for (std::string& line : lines) line.erase(0, std::min(line.find_first_not_of(' '), line.size()));
  return lines;
}

/// Whether the lines stand in the text, one after the other.
bool quotes(const std::string& text, const std::string& lines) {
  const std::vector<std::string> all = outdented(text), quoted = outdented(lines);
  return !quoted.empty() && std::search(all.begin(), all.end(), quoted.begin(), quoted.end()) != all.end();
}

class Links : public testing::TestWithParam<std::string> {};

TEST_P(Links, LeadSomewhere) {
  const docs::Page page = docs::parse_page(GetParam(), house::text_of(GetParam()));
  for (const auto& link : page.links) {
    EXPECT_EQ(defect_of(page, link), "") << page.path << ":" << link.line << ": " << link.target;
  }
}

TEST_P(Links, PathsAndTestsThatAreNamedExist) {
  const docs::Page page = docs::parse_page(GetParam(), house::text_of(GetParam()));
  for (const auto& word : page.code) {
    EXPECT_EQ(defect_of(word.text), "") << page.path << ":" << word.line << ": " << word.text;
  }
}

TEST_P(Links, QuotedLinesStandInTheirFiles) {
  const docs::Page page = docs::parse_page(GetParam(), house::text_of(GetParam()));
  for (const auto& block : page.blocks) {
    if (block.of.empty()) continue;
    EXPECT_TRUE(quotes(house::text_of(block.of), block.text))
        << page.path << ":" << block.line << ": " << block.of << " has not these lines";
  }
}

TEST_P(Links, FiguresAreSmall) {
  const docs::Page page = docs::parse_page(GetParam(), house::text_of(GetParam()));
  for (const auto& link : page.links) {
    if (!link.target.ends_with(".png")) continue;
    EXPECT_LT(fs::file_size(root / fs::path(page.path).parent_path() / link.target), 400'000u) << link.target;
  }
}

INSTANTIATE_TEST_SUITE_P(Docs, Links, testing::ValuesIn(docs::pages()),
                         [](const auto& page) { return fs::path(page.param).stem().string(); });

TEST(LinksNegativeControl, LinesThatWereChangedAreNoQuote) {
  EXPECT_TRUE(quotes("{\n    a = b;\n    c = d;\n}\n", "a = b;\nc = d;\n"));
  EXPECT_FALSE(quotes("{\n    a = b;\n    c = e;\n}\n", "a = b;\nc = d;\n"));
  EXPECT_FALSE(quotes("a = b;\n\nc = d;\n", "a = b;\nc = d;\n"));
  EXPECT_FALSE(quotes("a\n", ""));
}

TEST(LinksNegativeControl, WhatIsNotThereIsMissed) {
  const docs::Page page = docs::parse_page("docs/page.md",
                                           "# A heading, here\n[a](../README.md) [b](nowhere.md) "
                                           "[c](#a-heading-here)\n`x` [d](../README.md#nothing)\n");
  ASSERT_EQ(page.links.size(), 4u);
  EXPECT_EQ(page.anchors, std::vector<std::string>{"a-heading-here"});
  EXPECT_EQ(defect_of(page, page.links[0]), "");
  EXPECT_EQ(defect_of(page, page.links[1]), "no such file");
  EXPECT_EQ(defect_of(page, page.links[3]), "no such heading");
  EXPECT_EQ(defect_of("harness/assay_material.h:update"), "");
  EXPECT_EQ(defect_of("harness/nothing.hpp"), "no such file");
  EXPECT_EQ(defect_of("harness/sheet/sheet.cpp:no_such_function"), "the file does not hold this name");
  EXPECT_EQ(defect_of("LinksNegativeControl.WhatIsNotThereIsMissed"), "");
  EXPECT_EQ(defect_of("LinksNegativeControl.Nothing"), "no such test");
  EXPECT_EQ(defect_of("error.l2_max"), "");
}

}  // namespace
}  // namespace assay::test_links
