// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/pages/study_pages.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/drivers/scratch_folder.hpp"
#include "tests/drivers/study/sample_study.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_study_junit {
namespace {

TEST(StudyJunit, a_death_is_a_finding_and_no_failure) {
  StudyFindings findings = sample_study();
  const auto has = [&](const std::string& text) { return study_junit(findings).find(text) != std::string::npos; };
  EXPECT_TRUE(has("tests=\"33\" failures=\"1\" errors=\"0\" skipped=\"1\"")) << study_junit(findings);
  EXPECT_TRUE(
      has("<failure message=\"order: expected above 1.5, found 1.12\" type=\"expectation\">order: expected above 1.5, "
          "found 1.12</failure>"));
  for (const char* outcome : {"missing", "crashed", "stopped"}) {
    findings.cases[0].outcome = outcome;
    EXPECT_TRUE(has("failures=\"2\"")) << outcome;
    EXPECT_TRUE(has("type=\"" + std::string(outcome) + "\"")) << outcome;
  }
}

TEST(StudyJunit, is_valid) {
  if (std::system("xmllint --version > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "xmllint is not installed (libxml2-utils): JUnit files are not validated";
  const ScratchFolder scratch;
  StudyFindings odd = failed_study();
  odd.cases[0].outcome = "crashed";
  odd.cases[0].reason = "signal 11 <&\"'> \x01";
  for (const StudyFindings& findings : {sample_study(), odd, StudyFindings()}) {
    const std::string file = scratch.write("study.xml", study_junit(findings)), said = scratch / "said";
    const std::string command = "xmllint --noout --relaxng '" + tree_folder() + "/tests/drivers/junit.rng' '" + file +
                                "' > '" + said + "' 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0) << bytes_of(said) << bytes_of(file);
  }
}

}  // namespace
}  // namespace assay::drivers::test_study_junit
