// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "drivers/check/check_report.hpp"

namespace assay::drivers::test_check_text {
namespace {

CheckedMaterial checked_with(const check::TestResult& test) {
  CheckedMaterial checked;
  checked.name = "clay";
  checked.report.tests.push_back(test);
  return checked;
}

TEST(CheckText, AMeasureAboveItsThresholdExplainsItself) {
  check::TestResult test{.id = "rotation.state", .measure = 0.5, .threshold = 0.1};
  test.sentence = "in axes of its own";
  const std::string above = check_text(checked_with(test), Verbosity::normal);
  EXPECT_NE(above.find("\n    in axes of its own\n"), std::string::npos) << above;
  test.measure = 0.05;
  const std::string below = check_text(checked_with(test), Verbosity::normal);
  EXPECT_EQ(below.find("in axes"), std::string::npos) << below;
}

/// The first line counts them, and CI finds them in the JUnit file.
TEST(CheckText, RemarksAreCountedInTheVerdictAndKeptForCi) {
  CheckedMaterial checked = checked_with({.id = "rest", .sentence = "no stress"});
  EXPECT_EQ(check_text(checked, Verbosity::quiet).find("remark"), std::string::npos);
  checked.report.tests.push_back({.id = "memory", .sentence = "a remark: no step uses it"});
  checked.report.tests.push_back({.id = "rotation.state", .measure = 0.5, .threshold = 0.1, .sentence = "own axes"});
  EXPECT_NE(check_text(checked, Verbosity::quiet).find("; 2 remarks"), std::string::npos);
  const std::string xml = check_junit({checked});
  EXPECT_NE(xml.find("name=\"remark of memory\" value=\"a remark: no step uses it\""), std::string::npos) << xml;
  EXPECT_NE(xml.find("name=\"remark of rotation.state\" value=\"own axes\""), std::string::npos) << xml;
}

TEST(CheckText, WarningsAreCountedInTheVerdictAndKeptForCi) {
  CheckedMaterial checked = checked_with({.id = "rest", .sentence = "no stress"});
  EXPECT_EQ(check_text(checked, Verbosity::quiet).find("warning"), std::string::npos);
  EXPECT_NE(check_json(checked).find("\"warnings\": []"), std::string::npos) << check_json(checked);
  checked.warnings = {"m.f:3: 'elam' is used uninitialized"};
  EXPECT_NE(check_text(checked, Verbosity::quiet).find("; 1 warning\n"), std::string::npos);
  checked.warnings.push_back("m.f:4: MU is an integer");
  EXPECT_NE(check_text(checked, Verbosity::quiet).find("; 2 warnings\n"), std::string::npos);
  EXPECT_NE(check_text({checked}, 1).find("warning: m.f:4: MU is an integer\n"), std::string::npos) << "of all";
  const auto read = checked_of_json(check_json(checked));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->warnings, checked.warnings);
  const std::string xml = check_junit({checked});
  EXPECT_NE(xml.find("name=\"warning\" value=\"m.f:4: MU is an integer\""), std::string::npos) << xml;
}

TEST(CheckText, TheVerdictLineSaysWhatTheAnswerDependsOn) {
  CheckedMaterial checked = checked_with({.id = "rest", .sentence = "no stress"});
  checked.depends_on = {{"TEMP", "2 % for +10"}, {"NOEL", "1 % at 2"}};
  const std::string words = "depends on TEMP (2 % for +10), NOEL (1 % at 2)";
  EXPECT_NE(check_text({checked}, 1).find(words), std::string::npos) << "of all materials";
  std::string one;
  for (const char c : check_text(checked, Verbosity::quiet)) one += c == '\n' ? ' ' : c;
  for (std::size_t at; (at = one.find("  ")) != std::string::npos;) one.erase(at, 1);
  EXPECT_NE(one.find("; " + words), std::string::npos) << one;
  const auto read = checked_of_json(check_json(checked));
  ASSERT_TRUE(read);
  ASSERT_EQ(read->depends_on.size(), 2u);
  EXPECT_EQ(read->depends_on[1].how, "1 % at 2");
  EXPECT_NE(check_junit({checked}).find("depends on TEMP"), std::string::npos);
}

}  // namespace
}  // namespace assay::drivers::test_check_text
