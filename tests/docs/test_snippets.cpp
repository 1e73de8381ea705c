// SPDX-License-Identifier: BSD-3-Clause
// What the pages tell a reader to type works, and prints what they say.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/docs/snippets.hpp"
#include "tests/house/tree.hpp"

namespace assay::test_snippets {
namespace {

using namespace assay::docs;

class Snippets : public testing::TestWithParam<std::string> {};

std::string stem_of(const std::string& path) { return std::filesystem::path(path).stem().string(); }

TEST_P(Snippets, Run) {
  const Page page = parse_page(GetParam(), assay::house::text_of(GetParam()));
  if (!ASSAY_CAN_INSTALL && page.path == "docs/plugin.md") GTEST_SKIP() << "this build has no install rules";
  EXPECT_EQ(run_page(page, scratch_folder(stem_of(page.path))), "");
}

// A misspelt language or info word would leave a block out in silence.
TEST_P(Snippets, SayWhatTheyAre) {
  const std::vector<std::string> known{"sh",       "console", "c",    "cpp",     "cmake",  "yaml",
                                       "csv",      "json",    "text", "fortran", "python", "plugin",
                                       "own_code", "study",   "umat", "verify",  "scene"};
  for (const Block& block : parse_page(GetParam(), assay::house::text_of(GetParam())).blocks) {
    const std::string where = GetParam() + ":" + std::to_string(block.line);
    EXPECT_NE(std::find(known.begin(), known.end(), block.language), known.end()) << where << ": " << block.language;
    EXPECT_TRUE(block.unknown_words.empty()) << where << ": " << block.unknown_words.front();
  }
}

/// Those whose commands take more than five seconds of one core.
std::vector<std::string> pages_that_take(bool long_) {
  const std::set<std::string> slow{"standard", "scenes", "paths",    "resolution", "ci",   "report", "commands",
                                   "python",   "plugin", "own_code", "study",      "umat", "verify", "scene"};
  std::vector<std::string> chosen = pages();
  std::erase_if(chosen, [&](const std::string& page) { return slow.contains(stem_of(page)) != long_; });
  return chosen;
}
const auto name_of_page = [](const auto& page) { return stem_of(page.param); };
INSTANTIATE_TEST_SUITE_P(Docs, Snippets, testing::ValuesIn(pages_that_take(false)), name_of_page);
INSTANTIATE_TEST_SUITE_P(LongDocs, Snippets, testing::ValuesIn(pages_that_take(true)), name_of_page);

std::string complaint_of(const std::string& markdown) {
  const Page page = parse_page("page.md", markdown);
  const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
  return run_page(page, scratch_folder("control_" + name));
}

TEST(SnippetsNegativeControl, ACommandThatFailsIsCaught) {
  EXPECT_EQ(complaint_of("```sh\ntrue\n```\n"), "");
  EXPECT_NE(complaint_of("text\n\n```sh\nfalse\ntrue\n```\n").find("page.md:3: exit 1"), std::string::npos);
  EXPECT_NE(complaint_of("```sh\nassay run nowhere.yaml\n```\n").find("nowhere.yaml"), std::string::npos);
  EXPECT_EQ(complaint_of("```sh skip\nfalse\n```\n"), "");
  EXPECT_EQ(complaint_of("```sh needs=no_such_program\nfalse\n```\n"), "");
  EXPECT_NE(complaint_of("```sh needs=sh\nfalse\n```\n"), "");
}

TEST(SnippetsNegativeControl, AnotherOutputIsCaught) {
  EXPECT_EQ(complaint_of("```console\n$ assay run nowhere.yaml\nnowhere.yaml: cannot be read: No such file or "
                         "directory\n$ echo $?\n2\n```\n"),
            "");
  EXPECT_NE(complaint_of("```console\n$ assay run nowhere.yaml\nnowhere.yaml: not there\n```\n"), "");
  EXPECT_NE(complaint_of("```console\n$ echo one\n```\n"), "");
  EXPECT_NE(complaint_of("```console\n$ true\none\n```\n"), "");
  EXPECT_NE(complaint_of("```console\n$ exit 0\n$ true\n```\n"), "");
}

TEST(SnippetsNegativeControl, BlocksShareTheirFolderInOrder) {
  const std::string file = "```text title=sub/a.txt\nhello\n```\n",
                    reader = "```console\n$ cat sub/a.txt\nhello\n```\n";
  EXPECT_EQ(complaint_of(file + reader), "");
  EXPECT_NE(complaint_of(reader + file), "");
}

TEST(SnippetsNegativeControl, DotsStandForAnythingAndNothingElseDoes) {
  EXPECT_TRUE(agrees("a ... c\n", "a b b c\n"));
  EXPECT_TRUE(agrees("a\n...\nz\n", "a\nb\nc\nz\n"));
  EXPECT_TRUE(agrees("...\n", ""));
  EXPECT_TRUE(agrees("1 ... 2 ... 3", "1 2 2 4 3"));
  EXPECT_FALSE(agrees("a ... c\n", "a b d\n"));
  EXPECT_FALSE(agrees("a...a\n", "a\n"));
  EXPECT_FALSE(agrees("a\n...\nz\n", "a\nb\n"));
  EXPECT_FALSE(agrees("a\n", "a\nb\n"));
}

TEST(SnippetsNegativeControl, AnOpenFenceIsRefused) {
  EXPECT_THROW(parse_page("page.md", "```sh\ntrue\n"), std::runtime_error);
}

}  // namespace
}  // namespace assay::test_snippets
