// SPDX-License-Identifier: BSD-3-Clause
// The reference of the command line has the words of the program's help, and nothing besides.
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "tests/house/tree.hpp"

namespace assay::test_commands {
namespace {

using namespace assay::house;

/// What the help lists under "Positionals" and "Options" as rows of a table: "| `--strain NUMBER` | largest ... |".
std::set<std::string> rows_of_help(const std::string& help) {
  constexpr std::size_t column = 28;  // at which the meaning begins
  std::set<std::string> rows;
  std::string name, meaning;
  bool listed = false;
  const auto end_row = [&] {
    name = std::regex_replace(name, std::regex(R"( (\(required\)|Excludes:.*)$)"), "");
    if (!name.empty()) rows.insert("`" + name + "` | " + meaning);
    name.clear(), meaning.clear();
  };
  for (const std::string& line : lines_of(help)) {
    const bool heading = line == "Positionals:" || line == "Options:";
    if (heading || line.empty() || !line.starts_with("  ")) {
      end_row();
      listed = heading;
      continue;
    }
    if (!listed) continue;
    const std::size_t begin = line.find_first_not_of(' ');
    if (begin < column) end_row();
    const bool alone = begin < column && (line.size() <= column || line[column - 1] != ' ');
    if (begin < column) name = alone ? line.substr(begin) : line.substr(begin, column - begin);
    name.erase(name.find_last_not_of(' ') + 1);
    if (!alone) meaning += (meaning.empty() ? "" : " ") + line.substr(std::max(begin, column));
  }
  end_row();
  return rows;
}

/// The rows of the section of that heading whose first cell is code; what stands behind the code of a cell is left out.
std::set<std::string> rows_of_page(const std::string& page, const std::string& heading) {
  static const std::regex row(R"(^\| (`[^`]+`)[^|]* \| (.*) \|$)");
  std::set<std::string> rows;
  bool inside = false, in_options = false;
  for (const std::string& line : lines_of(page)) {
    if (line.starts_with("## ")) inside = line == "## " + heading;
    if (line == "| Option | Meaning |") in_options = true;
    if (!line.starts_with("|")) in_options = false;
    std::smatch match;
    if (inside && in_options && std::regex_match(line, match, row))
      rows.insert(match[1].str() + " | " + match[2].str());
  }
  return rows;
}

TEST(Commands, TheReferenceHasTheWordsOfTheHelp) {
  const std::string page = text_of("docs/commands.md");
  const std::vector<std::string> known = verbs();
  ASSERT_GE(known.size(), 12u);
  for (const std::string& verb : known) {
    const std::set<std::string> help = rows_of_help(run_assay(verb + " --help").output);
    EXPECT_GE(help.size(), 3u) << verb;
    EXPECT_EQ(rows_of_page(page, verb), help) << verb;
  }
}

TEST(Commands, TheReferenceListsTheVerbsInTheOrderOfTheHelp) {
  std::vector<std::string> headings;
  const std::vector<std::string> known = verbs();
  for (const std::string& line : lines_of(text_of("docs/commands.md"))) {
    const std::string word = line.starts_with("## ") ? line.substr(3) : "";
    if (std::find(known.begin(), known.end(), word) != known.end()) headings.push_back(word);
  }
  EXPECT_EQ(headings, known);
}

TEST(CommandsNegativeControl, AnotherWordOrAMissingOptionIsSeen) {
  const std::string help =
      "x\n\nOptions:\n  -o DIR                    folder\n  --as NAME Excludes: --remove\n                            "
      "a name\n"
      "                            and more\n\nExample:\n  --no option here\n";
  const std::set<std::string> rows{"`-o DIR` | folder", "`--as NAME` | a name and more"};
  EXPECT_EQ(rows_of_help(help), rows);
  const std::string page =
      "## x\n| Option | Meaning |\n| --- | --- |\n| `-o DIR` | folder |\n| `--as NAME` (excludes `--b`) | a name and "
      "more |\n";
  EXPECT_EQ(rows_of_page(page, "x"), rows);
  EXPECT_NE(rows_of_page(page + "| `--more` | of it |\n", "x"), rows);
  EXPECT_TRUE(rows_of_page(page, "y").empty());
}

}  // namespace
}  // namespace assay::test_commands
