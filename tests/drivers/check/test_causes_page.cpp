// SPDX-License-Identifier: BSD-3-Clause
// docs/causes.md has a section for every cause that a check can name, and the program prints it.
#include "drivers/check/check.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

#include "tests/drivers/process.hpp"
#include "tests/harness/check/all_causes.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_causes_page {
namespace {

std::string file_of(const std::string& name) {
  std::ifstream in(tree_folder() + "/" + name);
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

TEST(CausesPage, IsTheDocument) { EXPECT_EQ(causes_page(), file_of("docs/causes.md")); }

TEST(CausesPage, ExplainsEveryCauseOnce) {
  const std::vector<std::string> found = explained_causes();
  const std::set<std::string> explained(found.begin(), found.end());
  EXPECT_EQ(explained.size(), found.size()) << "one is there twice";
  const std::vector<std::string>& all = check::all_causes();
  EXPECT_EQ(explained, std::set<std::string>(all.begin(), all.end()));
}

TEST(CausesPage, SaysOfEachWhatItMeansAndHowToRepairIt) {
  for (const std::string& cause : check::all_causes()) {
    const std::string text = explained_cause(cause);
    EXPECT_TRUE(text.starts_with(cause + "\n")) << cause;
    for (const char* part :
         {"Typical mistakes.", "1. ", "2. ", "3. ", "Where to look.", "Repair.", "Wrong:", "Right:"}) {
      EXPECT_NE(text.find(part), std::string::npos) << cause << ": " << part;
    }
    EXPECT_EQ(text.find("```"), std::string::npos) << cause;
    EXPECT_EQ(text.find("**Where"), std::string::npos) << cause;
    EXPECT_EQ(std::count(text.begin(), text.end(), '['), std::count(text.begin(), text.end(), ']')) << cause;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      EXPECT_LE(line.size(), 80u) << cause << ": " << line;
      const bool is_code = line.starts_with("    ");
      EXPECT_TRUE(is_code || line.find("  ", line.find_first_not_of(' ')) == line.npos) << cause << ": " << line;
    }
  }
}

TEST(CausesPage, IsNamedBelowAFailureAndPrintedByTheProgram) {
  const Ending shown = assay({"check", "--explain", "wrong spin"});
  EXPECT_EQ(shown.status, 0);
  EXPECT_EQ(shown.said, explained_cause("wrong spin"));
  const Ending list = assay({"check", "--explain", "all"});
  EXPECT_EQ(std::count(list.said.begin(), list.said.end(), '\n'),
            static_cast<std::ptrdiff_t>(check::all_causes().size()));
}

TEST(CausesPage, ACauseThatNobodyNamesIsOneLine) {
  const Ending ending = assay({"check", "--explain", "wrong spinn"});
  EXPECT_EQ(ending.status, 2);
  EXPECT_NE(ending.said.find("unknown cause (nearest: wrong spin)"), std::string::npos) << ending.said;
  EXPECT_EQ(std::count(ending.said.begin(), ending.said.end(), '\n'), 1);
  EXPECT_EQ(assay({"check", "neo_hookean", "--explain", "clock"}).status, 2);
}

}  // namespace
}  // namespace assay::drivers::test_causes_page
