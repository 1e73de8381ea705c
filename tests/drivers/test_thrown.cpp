// SPDX-License-Identifier: BSD-3-Clause
// The ABI is C: an exception of a model is a finding about the model, and no bug of ours.
#include <gtest/gtest.h>

#include <algorithm>

#include <nlohmann/json.hpp>

#include "tests/drivers/misdeeds.hpp"
#include "tests/support/some_of.hpp"

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

/// Every function of the ABI's table and of its extensions: "FUNCTION runtime_error".
const char* const functions[] = {"entry", "create", "create_of", "begin",      "update", "extension", "extension_of",
                                 "rate",  "tau",    "tangent",   "wave_speed", "energy", "reason"};

class ThrownAnywhere : public testing::TestWithParam<std::tuple<const char*, const char*>> {
 protected:
  std::string function_ = std::get<0>(GetParam()), isolation_ = std::get<1>(GetParam());
  std::string model_ = built("tests/plugins/throws.so");
  Misdeeds the_;

  Ending ending_of(std::vector<std::string> words) const {
    words.insert(words.end(), {"--set", "material.isolation=" + isolation_});
    return the_.program(words, function_ + " runtime_error");
  }
  std::vector<std::string> tabulate_words() const {
    return {"tabulate", the_.scene,
            "-o",       the_.scratch / "t",
            "--set",    "material.adapter=" + model_,
            "--set",    "material.parameters={}",
            "--set",    "motion.amplitude.peak=0.05",
            "--set",    "time.end=0.1"};
  }
};

/// A verb that comes to the function tells of the exception; one that does not tells of nothing.
TEST_P(ThrownAnywhere, IsTheModelsInEachVerb) {
  const bool of_check_alone = function_ == "energy" || function_ == "tangent";
  for (const auto& words : {the_.run_words(model_), tabulate_words(), the_.eval_words(model_)}) {
    const Ending found = ending_of(words);
    const bool may_stay_out = of_check_alone || (function_ == "wave_speed" && words[0] != "run") || function_ == "tau";
    EXPECT_TRUE((found.status == 0 && may_stay_out) || found.status == 1 || found.status == 2)
        << words[0] << " ends with " << found.status << ": " << found.said;
    for (const char* never : {"bug", "out of memory", "signal", "ended the process"})
      EXPECT_EQ(unwrapped(found.said).find(never), std::string::npos) << words[0] << ": " << found.said;
    if (found.status == 0) continue;
    EXPECT_NE(unwrapped(found.said).find(test_thrown::words), std::string::npos) << words[0] << ": " << found.said;
    EXPECT_NE(unwrapped(found.said).find("no root is found"), std::string::npos) << words[0] << ": " << found.said;
  }
}

std::string name_of(const testing::TestParamInfo<std::tuple<const char*, const char*>>& instance) {
  return std::get<0>(instance.param) + std::string("_") + std::get<1>(instance.param);
}

const auto cases_of_thrown_anywhere = one_of_each<ThrownAnywhere::ParamType>(
    3, testing::Combine(testing::ValuesIn(functions), testing::Values("none", "worker")));
INSTANTIATE_TEST_SUITE_P(Functions, ThrownAnywhere, testing::ValuesIn(cases_of_thrown_anywhere.some), name_of);
INSTANTIATE_TEST_SUITE_P(LongFunctions, ThrownAnywhere, testing::ValuesIn(cases_of_thrown_anywhere.others), name_of);

class ThrownInCheck : public Thrown {};

TEST_P(ThrownInCheck, IsNamed) {
  const std::string deed = GetParam() + std::string(" runtime_error");
  const Ending check = the_.program({"check", model_, "--quick", "-o", the_.scratch / "r"}, deed);
  EXPECT_TRUE(check.status == 1 || check.status == 2) << check.status << ": " << check.said;
  EXPECT_NE(unwrapped(check.said).find(words), std::string::npos) << check.said;
  for (const char* never : {"bug", "refuses a step", "ended the process"})
    EXPECT_EQ(unwrapped(check.said).find(never), std::string::npos) << check.said;
}

INSTANTIATE_TEST_SUITE_P(Functions, ThrownInCheck, testing::ValuesIn(functions),
                         [](const auto& instance) { return std::string(instance.param); });

const char* const of_extensions[] = {"rate", "tau", "tangent", "wave_speed", "energy"};

class ExtensionInCheck : public Thrown {};

TEST_P(ExtensionInCheck, IsHeldToItsArraysAndItsStatus) {
  const auto said = [&](const std::string& deed) {
    const Ending check = the_.program({"check", model_, "--quick", "-o", the_.scratch / "r"}, GetParam() + deed);
    EXPECT_EQ(check.status, 1) << check.said;
    return unwrapped(check.said);
  };
  const std::string overrun = said(" overrun"), status = said(" status");
  EXPECT_NE(overrun.find("diagnosis: overrun " + std::string(GetParam()) + " writes beyond its results"),
            std::string::npos)
      << overrun;
  EXPECT_NE(status.find(GetParam() + std::string(" returned the status 7, which is none of the ABI's")),
            std::string::npos)
      << status;
}

INSTANTIATE_TEST_SUITE_P(Functions, ExtensionInCheck, testing::ValuesIn(of_extensions),
                         [](const auto& instance) { return std::string(instance.param); });

/// It is not told as one that is not there, nor asked again.
TEST_P(Thrown, ADeathInAnExtensionIsNamedFromAWorkerToo) {
  const std::string function = GetParam();
  std::vector<std::string> words = the_.run_words(model_);
  words.insert(words.end(), {"--set", "material.isolation=worker"});
  if (function == "tau") words.insert(words.end(), {"--set", "force.response=closed_form"});
  for (const std::string deed : {" abort", " overrun"}) {
    const Ending run = the_.program(words, function + deed);
    EXPECT_EQ(run.status, 1) << run.said;
    const char* said = deed == " abort" ? "was ended by signal 6" : "overrun";
    EXPECT_NE(unwrapped(run.said).find(said), std::string::npos) << run.said;
    EXPECT_EQ(run.said.find("offers no"), std::string::npos) << run.said;
  }
}

INSTANTIATE_TEST_SUITE_P(Extensions, Thrown, testing::Values("rate", "tau", "wave_speed"),
                         [](const auto& instance) { return std::string(instance.param); });

class RateForm : public testing::TestWithParam<const char*> {};

TEST_P(RateForm, ThatFailsIsTold) {
  const Misdeeds the;
  std::vector<std::string> words = the.run_words(built("tests/plugins/throws.so"));
  words.insert(words.end(), {"--set", "material.isolation=" + std::string(GetParam())});
  const Ending failed = the.program(words, "rate fails");
  EXPECT_EQ(failed.status, 1) << failed.said;
  EXPECT_NE(unwrapped(failed.said).find("its rate form failed"), std::string::npos) << failed.said;
  const Ending without = the.program(words, "rate null");
  EXPECT_EQ(without.status, 0) << without.said;
}

INSTANTIATE_TEST_SUITE_P(Isolations, RateForm, testing::Values("none", "worker"),
                         [](const auto& instance) { return std::string(instance.param); });

#if defined(__x86_64__)
TEST(Unaligned, AddressesAreNamed) {
  const Misdeeds the;
  const Ending check =
      the.program({"check", built("tests/plugins/throws.so"), "--quick", "-o", the.scratch / "r"}, "update unaligned");
  EXPECT_EQ(check.status, 1) << check.said;
  EXPECT_NE(unwrapped(check.said).find("it used an address that is not aligned"), std::string::npos) << check.said;
}
#endif

TEST(LongThrown, WordsThatDoNotComeEndWithTheCall) {
  const Misdeeds the;
  const Ending check =
      the.program({"check", built("tests/plugins/throws.so"), "--quick", "-o", the.scratch / "r"}, "update waits");
  EXPECT_EQ(check.status, 1) << check.said;
  EXPECT_NE(unwrapped(check.said).find("did not return from a call within 20 s"), std::string::npos) << check.said;
}

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
