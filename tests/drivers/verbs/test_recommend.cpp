// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/drivers/study/verb_call.hpp"

namespace assay::drivers::test_recommend {
namespace {

TEST(Recommend, FindsTheStudyByFolderFileAndYaml) {
  const ScratchFolder scratch;
  const std::string folder = study_in(scratch, "methods", two_method_study());
  const std::string yaml = scratch.write("study.yaml", "title: Two methods\n");
  const VerbOutcome by_folder = call_verb({"recommend", folder, "--error", "1e-2"});
  EXPECT_EQ(by_folder.status, 0) << by_folder.err;
  EXPECT_EQ(by_folder.err, "");
  EXPECT_NE(by_folder.out.find("take B2, AFLIP, grid.spacing=0.05\n"), std::string::npos) << by_folder.out;
  EXPECT_NE(by_folder.out.find("assay run " + folder + "/cases/B05/case.yaml --threads 2\n"), std::string::npos);
  EXPECT_EQ(call_verb({"recommend", folder + "/study.json", "--error", "1 %"}).out, by_folder.out);
  EXPECT_EQ(call_verb({"recommend", yaml, "-o", folder, "--error=1%"}).out, by_folder.out);
}

TEST(Recommend, YamlHasItsDefaultFolder) {
  const ScratchFolder scratch;
  const auto before = std::filesystem::current_path();
  study_in(scratch, "results/methods", two_method_study());
  scratch.write("methods.yaml", "");
  std::filesystem::current_path(scratch / "");
  const VerbOutcome found = call_verb({"recommend", "methods.yaml", "--error", "1e-2"});
  std::filesystem::current_path(before);
  EXPECT_EQ(found.status, 0) << found.err;
  EXPECT_NE(found.out.find("assay run results/methods/cases/B05/case.yaml"), std::string::npos) << found.out;
}

TEST(Recommend, OneWhereNoCaseMeetsTheError) {
  const ScratchFolder scratch;
  const VerbOutcome found = call_verb({"recommend", study_in(scratch, "a", two_method_study()), "--error", "1e-6"});
  EXPECT_EQ(found.status, 1);
  EXPECT_EQ(found.err, "");
  EXPECT_NE(found.out.find("the best found: B2, AFLIP, grid.spacing=0.025"), std::string::npos) << found.out;
}

TEST(Recommend, AnswersInJson) {
  const ScratchFolder scratch;
  const std::string folder = study_in(scratch, "a", two_method_study());
  const VerbOutcome found = call_verb({"recommend", folder, "--error", "1e-2", "--json"});
  EXPECT_EQ(found.status, 0);
  EXPECT_EQ(nlohmann::json::parse(found.out)["recommended"]["folder"], folder + "/cases/B05");
}

TEST(Recommend, WithoutAnErrorTheHardiestMethod) {
  const ScratchFolder scratch;
  StudyFindings study = two_method_study();
  EXPECT_EQ(call_verb({"recommend", study_in(scratch, "a", study)}).status, 0);
  for (StudyCase& one : study.cases) {
    if (one.completed() && one.resolution == 0.1) one.outcome = "unstable";
  }
  const VerbOutcome found = call_verb({"recommend", study_in(scratch, "b", study), "--json"});
  EXPECT_EQ(found.status, 1) << "it dies, too";
  EXPECT_EQ(nlohmann::json::parse(found.out)["recommended"], "B2, AFLIP");
}

TEST(Recommend, BadInputIsOneLineAndTwo) {
  const ScratchFolder scratch;
  const std::string folder = study_in(scratch, "a", two_method_study()), empty = scratch / "empty";
  std::filesystem::create_directories(empty);
  const std::string yaml = scratch.write("other.yaml", ""),
                    torn = scratch.write("torn.json", "{\"format\": \"assay st");
  StudyFindings metres = two_method_study();
  metres.error_unit = "m";
  const std::string in_metres = study_in(scratch, "m", metres);
  const std::vector<std::vector<std::string>> calls{
      {"recommend"},
      {"recommend", "--error", "1"},
      {"recommend", folder, "--error"},
      {"recommend", folder, "--error", ""},
      {"recommend", folder, "--error", "small"},
      {"recommend", folder, "--error", "-1"},
      {"recommend", folder, "--error", "0"},
      {"recommend", in_metres, "--error", "1%"},
      {"recommend", folder, "--error", "1", "-o", folder},
      {"recommend", yaml, "--error", "1", "-o", empty},
      {"recommend", yaml, "--error", "1"},
      {"recommend", empty, "--error", "1"},
      {"recommend", scratch / "nowhere", "--error", "1"},
      {"recommend", "", "--error", "1"},
      {"recommend", torn, "--error", "1"},
      {"recommend", folder, folder, "--error", "1"},
  };
  for (const auto& words : calls) {
    const VerbOutcome outcome = call_verb(words);
    EXPECT_TRUE(outcome.is_refusal()) << testing::PrintToString(words) << outcome.status << outcome.out << outcome.err;
  }
  EXPECT_EQ(call_verb({"recommend", torn, "--error", "1"}).err, torn + ":1:21: is torn: it ends too early\n");
}

}  // namespace
}  // namespace assay::drivers::test_recommend
