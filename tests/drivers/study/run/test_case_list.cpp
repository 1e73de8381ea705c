// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/run/case_store.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/drivers/scratch_folder.hpp"

namespace assay::drivers::test_case_list {
namespace {

PlannedCase listed_case(std::size_t number, const std::string& key) {
  PlannedCase one;
  one.number = number, one.key = key;
  one.label = "case " + std::to_string(number);
  one.values = {{"method", "CPDI, \"FLIP\""}, {"grid.spacing", "0.05"}};
  one.yaml = "title: a\n";
  one.threads = 3, one.timed = true;
  one.particle_steps = 1234567.6;
  return one;
}

/// Of each state one: finished, missing, torn, crashed, n/a.
class CaseList : public testing::Test {
 protected:
  CaseList() : store_(scratch_ / "results") {
    for (const char* key : {"aa", "bb", "cc", "dd", ""}) {
      plan_.cases.push_back(listed_case(plan_.cases.size() + 1, key));
    }
    for (const std::size_t i : {0u, 2u, 3u}) {
      const PlannedCase& one = plan_.cases[i];
      store_.begin(one);
      if (i != 3) scratch_.write("results/cases/" + one.key + "/result.json", "{}");
      CaseRecord record;
      if (i == 3) record.crashed = "signal 11";
      store_.finish(one, record);
    }
    scratch_.write("results/cases/cc/result.json", "{ }");
    plan_.cases[4].invalid = "study.yaml:3:1: grid.spacing: must be greater than 0";
    plan_.cases[4].timed = false, plan_.cases[4].particle_steps = 0;
    plan_.cases[4].label = "a\tb\nc";
  }

  ScratchFolder scratch_;
  CaseStore store_;
  Plan plan_;
};

TEST_F(CaseList, IsALineACase) {
  EXPECT_EQ(list_text(plan_, store_),
            "1\taa\tfinished\t1234568\tcase 1\n"
            "2\tbb\tmissing\t1234568\tcase 2\n"
            "3\tcc\ttorn\t1234568\tcase 3\n"
            "4\tdd\tcrashed\t1234568\tcase 4\n"
            "5\t-\tn/a\t0\ta b c\n");
  EXPECT_EQ(list_text(Plan(), store_), "");
}

TEST_F(CaseList, TellsTheSameAsJson) {
  const auto all = nlohmann::json::parse(list_json(plan_, store_));
  ASSERT_EQ(all.size(), 5u);
  EXPECT_EQ(all[0], nlohmann::json({{"number", 1},
                                    {"key", "aa"},
                                    {"state", "finished"},
                                    {"threads", 3},
                                    {"timed", true},
                                    {"particle_steps", 1234567.6},
                                    {"label", "case 1"},
                                    {"values", {{"method", "CPDI, \"FLIP\""}, {"grid.spacing", "0.05"}}},
                                    {"reason", nullptr}}));
  const char* states[] = {"finished", "missing", "torn", "crashed", "n/a"};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(all[i]["state"], states[i]);
  EXPECT_TRUE(all[4]["key"].is_null());
  EXPECT_EQ(all[4]["reason"], plan_.cases[4].invalid);
  EXPECT_EQ(all[4]["label"], "a\tb\nc");
  EXPECT_EQ(list_json(Plan(), store_), "[]\n");
}

TEST_F(CaseList, WhatIsNoUtf8IsStillJson) {
  plan_.cases[0].label =
      "a\xff"
      "b";
  EXPECT_EQ(nlohmann::json::parse(list_json(plan_, store_))[0]["label"],
            "a\xef\xbf\xbd"
            "b");
}

}  // namespace
}  // namespace assay::drivers::test_case_list
