// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/drivers/study/verb_call.hpp"

namespace assay::drivers::test_compare {
namespace {

class Compare : public testing::Test {
 protected:
  Compare() {
    StudyFindings slower = two_method_study();
    set_clock(slower.cases[1], {9.6, 9.7, 9.8});
    for (StudyCase& one : slower.cases) one.key += one.key.empty() ? "" : "b";  // of another program
    a = study_in(scratch, "a", two_method_study());
    b = study_in(scratch, "b", slower);
  }
  ScratchFolder scratch;
  std::string a, b;
};

TEST_F(Compare, NothingWorseIsZero) {
  const VerbOutcome same = call_verb({"compare", a, a});
  EXPECT_EQ(same.status, 0) << same.err;
  EXPECT_NE(same.out.find("\nNOTHING WORSE: "), std::string::npos) << same.out;
  EXPECT_EQ(call_verb({"compare", b, a}).status, 0) << "faster";
}

TEST_F(Compare, SomethingWorseIsOne) {
  const VerbOutcome worse = call_verb({"compare", a, b + "/study.json"});
  EXPECT_EQ(worse.status, 1);
  EXPECT_EQ(worse.err, "");
  EXPECT_NE(worse.out.find("SLOWER"), std::string::npos) << worse.out;
  EXPECT_EQ(call_verb({"compare", a, b, "--quiet"}).out, "WORSE: 1 slower, 1 still fails, 7 the same\n");
  EXPECT_GT(call_verb({"compare", a, b, "-v"}).out.size(), worse.out.size());
}

TEST_F(Compare, WritesMarkdownAndJson) {
  const std::string file = scratch / "difference.md";
  EXPECT_EQ(call_verb({"compare", a, b, "--markdown", file, "--quiet"}).status, 1);
  EXPECT_TRUE(bytes_of(file).starts_with("**WORSE: 1 slower")) << bytes_of(file);
  EXPECT_EQ(call_verb({"compare", a, b, "--markdown", "-"}).out, bytes_of(file));
  const auto json = nlohmann::json::parse(call_verb({"compare", a, b, "--json"}).out);
  EXPECT_EQ(json["worse"], true);
  EXPECT_EQ(json["b"]["file"], b + "/study.json");
}

TEST_F(Compare, ReplacesNoResults) {
  for (const std::string& study : {a, b}) {
    const std::string file = study + "/study.json", before = bytes_of(file);
    const VerbOutcome outcome = call_verb({"compare", a, b, "--markdown", file});
    EXPECT_TRUE(outcome.is_refusal()) << outcome.status << outcome.out << outcome.err;
    EXPECT_NE(outcome.err.find("--markdown: '" + file + "' would replace an input"), std::string::npos) << outcome.err;
    EXPECT_EQ(bytes_of(file), before);
  }
}

TEST_F(Compare, BadInputIsOneLineAndTwo) {
  StudyFindings other = two_method_study();
  other.error_key = "error.l2_max";
  const std::string of_other = study_in(scratch, "c", other), json = scratch.write("torn.json", "{");
  const std::vector<std::vector<std::string>> calls{{"compare"},
                                                    {"compare", a},
                                                    {"compare", a, b, a},
                                                    {"compare", a, scratch / "nowhere"},
                                                    {"compare", a, of_other},
                                                    {"compare", json, a},
                                                    {"compare", a, b, "--json", "--markdown", "-"}};
  for (const auto& words : calls) {
    const VerbOutcome outcome = call_verb(words);
    EXPECT_TRUE(outcome.is_refusal()) << testing::PrintToString(words) << outcome.status << outcome.out << outcome.err;
  }
  EXPECT_EQ(call_verb({"compare", a, b, "--markdown", scratch / "no/folder/x.md"}).status, 3);
}

}  // namespace
}  // namespace assay::drivers::test_compare
