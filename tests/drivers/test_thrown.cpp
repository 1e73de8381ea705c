// SPDX-License-Identifier: BSD-3-Clause
// The ABI is C: an exception of a model is a finding about the model, and no bug of ours.
#include <gtest/gtest.h>

#include <algorithm>

#include <nlohmann/json.hpp>

#include "tests/drivers/misdeeds.hpp"

namespace assay::drivers::test_thrown {
namespace {

const std::string words = "threw an exception, which must not pass the C ABI";

/// Without the line breaks of a terminal.
std::string unwrapped(const std::string& text) {
  std::string line;
  for (const char c : text) {
    const bool blank = c == ' ' || c == '\n';
    if (!blank || line.empty() || line.back() != ' ') line += blank ? ' ' : c;
  }
  return line;
}

class Thrown : public testing::TestWithParam<const char*> {
 protected:
  std::string model_ = built("tests/plugins/throws.so");
  Misdeeds the_;
};

class ThrownInUpdate : public Thrown {};

TEST_P(ThrownInUpdate, IsAFailureOfTheMaterial) {
  const Ending run = the_.program(the_.run_words(model_), GetParam());
  EXPECT_EQ(run.status, 1) << run.said;
  const auto found = nlohmann::json::parse(bytes_of(the_.scratch / "out/result.json"));
  EXPECT_EQ(found["outcome"], "material_failed");
  EXPECT_NE(found["reason"].get<std::string>().find("the model " + words), std::string::npos) << found["reason"];
}

TEST_P(ThrownInUpdate, IsAFindingOfCheck) {
  const Ending check = the_.program(
      {"check", model_, "--quick", "--json", the_.scratch / "c.json", "-o", the_.scratch / "r"}, GetParam());
  EXPECT_EQ(check.status, 1) << check.said;
  const auto found = nlohmann::json::parse(bytes_of(the_.scratch / "c.json"));
  ASSERT_FALSE(found["diagnosis"].empty());
  EXPECT_EQ(found["diagnosis"][0]["cause"], "ends the process");
  EXPECT_NE(found["diagnosis"][0]["sentence"].get<std::string>().find(words), std::string::npos) << check.said;
}

INSTANTIATE_TEST_SUITE_P(Kinds, ThrownInUpdate,
                         testing::Values("update runtime_error", "update bad_alloc", "update int"),
                         [](const auto& instance) { return std::string(instance.param).substr(7); });

class ThrownBefore : public Thrown {};

TEST_P(ThrownBefore, IsTheModelsInOneLine) {
  const Ending run = the_.program(the_.run_words(model_), GetParam());
  EXPECT_TRUE(run.status == 1 || run.status == 2) << run.status << ": " << run.said;
  EXPECT_NE(unwrapped(run.said).find(words), std::string::npos) << run.said;
  const Ending check = the_.program({"check", model_, "--quick", "-o", the_.scratch / "r"}, GetParam());
  EXPECT_TRUE(check.status == 1 || check.status == 2) << check.status << ": " << check.said;
  EXPECT_NE(unwrapped(check.said).find(words), std::string::npos) << check.said;
  EXPECT_EQ(run.said.find("material.parameters"), std::string::npos) << run.said;
  for (const Ending* each : {&run, &check}) {
    EXPECT_EQ(each->said.find("bug"), std::string::npos) << each->said;
    EXPECT_EQ(each->said.find("delete it"), std::string::npos) << each->said;
  }
}

INSTANTIATE_TEST_SUITE_P(Places, ThrownBefore,
                         testing::Values("entry runtime_error", "entry int", "create runtime_error", "create bad_alloc",
                                         "create int", "begin runtime_error"),
                         [](const auto& instance) {
                           std::string name = instance.param;
                           std::replace(name.begin(), name.end(), ' ', '_');
                           return name;
                         });

}  // namespace
}  // namespace assay::drivers::test_thrown
