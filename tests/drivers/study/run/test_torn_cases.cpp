// SPDX-License-Identifier: BSD-3-Clause
// Files of finished cases that are not what they were: noticed, said and run again. All kinds: test_case_store.cpp.
#include <gtest/gtest.h>

#include "tests/drivers/study/study_program.hpp"

namespace assay::drivers::test_torn_cases {
namespace {

namespace fs = std::filesystem;

using Damage = std::function<void(const std::string& folder)>;

struct TornCase {
  const char* name;
  Damage damage;
  bool missing = false;  ///< it looks as if it had never been run
};

std::ostream& operator<<(std::ostream& out, const TornCase& torn) { return out << torn.name; }

/// Turns the lowest bit of the byte in the middle.
Damage flipped(const std::string& file) {
  return [file](const std::string& folder) {
    std::string bytes = bytes_of(folder + "/" + file);
    bytes[bytes.size() / 2] ^= 1;
    std::ofstream(folder + "/" + file, std::ios::binary) << bytes;
  };
}

Damage removed(const std::string& file) {
  return [file](const std::string& folder) { fs::remove(folder + "/" + file); };
}

Damage made_a_folder(const std::string& file) {
  return [file](const std::string& folder) {
    fs::remove(folder + "/" + file);
    fs::create_directories(folder + "/" + file + "/deep");
  };
}

class TornCases : public testing::TestWithParam<TornCase> {
 protected:
  static void SetUpTestSuite() {
    small_ = new SmallStudy(small_study_text("timing: {repeat: 2, where: {method: CPDI}}\n"));
    ASSERT_EQ(small_->run("undisturbed").status, 0);
  }
  static void TearDownTestSuite() {
    delete small_;
    small_ = nullptr;
  }
  void SetUp() override {
    out_ = small_->scratch / "out";
    fs::remove_all(out_);
    fs::copy(small_->scratch / "undisturbed", out_, fs::copy_options::recursive);
    const std::vector<std::string> folders = case_folders(out_);
    ASSERT_EQ(folders.size(), 4U);
    GetParam().damage(folders[1]);
    torn_ = folders[1];
  }

  static SmallStudy* small_;
  std::string out_, torn_;
};
using LongTornCases = TornCases;

SmallStudy* TornCases::small_ = nullptr;

TEST_P(TornCases, AreRunAgain) {
  const auto before = marks_of_cases(out_);
  const Ending resumed = small_->run("out", {"--resume"});
  EXPECT_EQ(resumed.status, 0) << resumed.said;
  EXPECT_NE(resumed.said.find("3 finished cases were kept\n"), std::string::npos) << resumed.said;
  EXPECT_EQ(resumed.said.find("warning: 1 torn case was run again\n") != std::string::npos, !GetParam().missing)
      << resumed.said;
  auto after = marks_of_cases(out_);
  EXPECT_EQ(after.size(), 4U);
  for (const auto& [folder, mark] : before) EXPECT_EQ(folder != torn_, after[folder] == mark) << folder;
  EXPECT_EQ(same_in_every_run(out_), same_in_every_run(small_->scratch / "undisturbed"));
}

TEST_P(LongTornCases, AreMissingInAMergeUnlessTakenFromElsewhere) {
  const Ending merged = small_->run("out", {"--merge"});
  EXPECT_EQ(merged.status, 1) << merged.said;
  EXPECT_EQ(
      merged.said.find("warning: 1 torn case is not trusted; run the study again with --resume\n") != std::string::npos,
      !GetParam().missing)
      << merged.said;
  EXPECT_NE(merged.said.find("1 missing"), std::string::npos) << merged.said;
  const Ending taken = small_->run("out", {"--merge", "--from", small_->scratch / "undisturbed"});
  EXPECT_EQ(taken.status, 0) << taken.said;
  EXPECT_EQ(same_in_every_run(out_), same_in_every_run(small_->scratch / "undisturbed"));
}

INSTANTIATE_TEST_SUITE_P(Files, TornCases,
                         testing::Values(TornCase{"result_a_folder", made_a_folder("result.json")},
                                         TornCase{"record_flipped", flipped("case.json")}),
                         [](const auto& torn) { return torn.param.name; });
INSTANTIATE_TEST_SUITE_P(LongFiles, TornCases,
                         testing::Values(TornCase{"errors_flipped", flipped("errors.csv")},
                                         TornCase{"record_missing", removed("case.json"), true}),
                         [](const auto& torn) { return torn.param.name; });
INSTANTIATE_TEST_SUITE_P(Files, LongTornCases,
                         testing::Values(TornCase{"result_a_folder", made_a_folder("result.json")},
                                         TornCase{"record_flipped", flipped("case.json")}),
                         [](const auto& torn) { return torn.param.name; });
INSTANTIATE_TEST_SUITE_P(LongFiles, LongTornCases,
                         testing::Values(TornCase{"errors_flipped", flipped("errors.csv")},
                                         TornCase{"record_missing", removed("case.json"), true}),
                         [](const auto& torn) { return torn.param.name; });

}  // namespace
}  // namespace assay::drivers::test_torn_cases
