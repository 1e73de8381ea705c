// SPDX-License-Identifier: BSD-3-Clause
// A native model that changes what its process may do with files, reads standard input, or stops processes: results
// stand, and `check` names it.
#include <gtest/gtest.h>

#include <csignal>
#include <nlohmann/json.hpp>

#include "tests/drivers/misdeeds.hpp"
#include "tests/support/some_of.hpp"
#include "tests/support/wait.hpp"

namespace assay::drivers::test_hostile_settings {
namespace {

namespace fs = std::filesystem;

/// In place of standard input, a pipe that nobody writes to and nobody closes.
void give_silent_input() {
  int ends[2];
  if (::pipe(ends) == 0) ::dup2(ends[0], STDIN_FILENO);
}

class HostileSettings : public testing::TestWithParam<const char*> {
 protected:
  Ending program(const std::vector<std::string>& words) const {
    return assay(words, [this] { give_silent_input(), the_.arm(std::string("update ") + GetParam()); });
  }
  Misdeeds the_;
};

TEST_P(HostileSettings, SpoilNoResult) {
  const Ending honest = the_.program(the_.run_words(the_.library, "honest"), "");
  ASSERT_EQ(honest.status, 0) << honest.said;
  for (const char* isolation : {"none", "worker"}) {
    std::vector<std::string> words = the_.run_words(the_.library);
    words.insert(words.end(), {"--set", std::string("material.isolation=") + isolation});
    const Ending ending = program(words);
    if (std::string(GetParam()) == "zero" && isolation == std::string("worker")) {
      EXPECT_LE(ending.status, 1) << ending.said;  // the particles are among what it shares
      continue;
    }
    EXPECT_EQ(ending.status, 0) << isolation << ": " << ending.said;
    EXPECT_EQ(bytes_of(the_.scratch / "out/errors.csv"), bytes_of(the_.scratch / "honest/errors.csv")) << isolation;
    EXPECT_NE(fs::status(the_.scratch / "out/errors.csv").permissions() & fs::perms::owner_read, fs::perms::none);
    EXPECT_TRUE(the_.nothing_is_left()) << isolation;
    fs::remove_all(the_.scratch / "out");
  }
  const Ending eval = program(the_.eval_words(the_.library));
  EXPECT_EQ(eval.status, 0) << eval.said;
}

TEST_P(HostileSettings, AreToldByCheck) {
  const Ending ending =
      program({"check", the_.library, "--quick", "--json", the_.scratch / "check.json", "-o", the_.scratch / "r"});
  EXPECT_EQ(ending.status, 1) << ending.said;
  const auto found = nlohmann::json::parse(bytes_of(the_.scratch / "check.json"));
  std::string sentence;
  for (const auto& each : found["diagnosis"]) {
    if (each["cause"] == "disturbs its process") sentence = each["sentence"];
  }
  const std::string deed = GetParam();
  EXPECT_EQ(sentence, deed == "umask"   ? "the model changes what may be done with new files (umask)"
                      : deed == "close" ? "the model closes or redirects standard output"
                      : deed == "leak"  ? "the model leaves files open"
                      : deed == "fork"  ? "the model leaves processes behind"
                                        : "")
      << ending.said;
  EXPECT_FALSE(fs::is_empty(the_.scratch / "r")) << "replays can be written";
}

const auto cases_of_hostile_settings =
    one_of_each<HostileSettings::ParamType>(3, testing::Values("umask", "close", "leak", "read", "zero", "fork"));
const auto name_of_hostile_settings = [](const auto& instance) { return std::string(instance.param); };
INSTANTIATE_TEST_SUITE_P(Deeds, HostileSettings, testing::ValuesIn(cases_of_hostile_settings.some),
                         name_of_hostile_settings);
INSTANTIATE_TEST_SUITE_P(LongDeeds, HostileSettings, testing::ValuesIn(cases_of_hostile_settings.others),
                         name_of_hostile_settings);

/// In each call, so that no repetition gets by.
TEST(LongStoppedProcesses, AreEndedByTheLimitOfACall) {
  for (const char* deed : {"each stop", "each stop_parent"}) {
    const Misdeeds the;
    const std::string model = the.scratch.write("model.yaml", "library: " + the.library + "\ntime_limit: 1\n");
    const Stopwatch watch;
    const Ending ending = the.program({"check", model, "--quick", "-o", the.scratch / "r"}, deed);
    EXPECT_LT(watch.seconds(), nobody_waited_s) << deed;
    EXPECT_EQ(ending.status, 1) << ending.said;
    EXPECT_TRUE(the.nothing_is_left()) << deed;
  }
}

}  // namespace
}  // namespace assay::drivers::test_hostile_settings
