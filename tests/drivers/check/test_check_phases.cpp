// SPDX-License-Identifier: BSD-3-Clause
// A model that ends or holds up the process of `check` beside its update: the verdict says at what.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/drivers/misdeeds.hpp"
#include "tests/support/some_of.hpp"

namespace assay::drivers::test_check_phases {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// `check` of the model that does that deed, with a second for each call.
class Checked {
 public:
  explicit Checked(const std::string& deed) {
    const std::string model = the_.scratch.write("model.yaml", "library: " + the_.library + "\ntime_limit: 1\n");
    ending = the_.program(
        {"check", model, "--quick", "--json", the_.scratch / "check.json", "-o", the_.scratch / "replays"}, deed);
    if (fs::exists(the_.scratch / "check.json")) found = Json::parse(bytes_of(the_.scratch / "check.json"));
    nothing_is_left = the_.nothing_is_left();
  }

  /// What it found of the model's end; none.
  Json end() const {
    for (const Json& each : found["diagnosis"]) {
      if (each["cause"] == "ends the process") return each["sentence"];
    }
    return "";
  }

  Ending ending;
  Json found;
  bool nothing_is_left = false;

 private:
  Misdeeds the_;
};

struct End {
  const char *deed, *words;
};

class CheckPhases : public testing::TestWithParam<End> {};

TEST_P(CheckPhases, AreNamed) {
  const Checked checked(GetParam().deed);
  EXPECT_EQ(checked.ending.status, 1) << checked.ending.said;
  EXPECT_NE(checked.end().get<std::string>().find(GetParam().words), std::string::npos) << checked.found.dump(1);
  EXPECT_GT(checked.found["tests"].size(), 1u) << "what was found before is kept";
  EXPECT_EQ(checked.ending.said.find("warning"), std::string::npos) << checked.ending.said;
  EXPECT_TRUE(checked.nothing_is_left);
}

const auto cases_of_check_phases = one_of_each<CheckPhases::ParamType>(
    3, testing::Values(
           End{"destroy abort", "was ended by signal 6 (Aborted) when it was destroyed in the test "},
           End{"destroy _exit", "ended the process with status 0 when it was destroyed in the test "},
           End{"destroy pause", "did not return from a call within 1 s when it was destroyed"},
           End{"destroy_first abort", "was ended by signal 6 (Aborted) when it was destroyed, after the last test"},
           End{"destroy_first _exit", "ended the process with status 0 when it was destroyed, after the last test"},
           End{"destroy_first pause", "within 1 s when it was destroyed, after the last test"}));
const auto name_of_check_phases = [](const auto& instance) {
  std::string name = instance.param.deed;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
};
INSTANTIATE_TEST_SUITE_P(Ends, CheckPhases, testing::ValuesIn(cases_of_check_phases.some), name_of_check_phases);
INSTANTIATE_TEST_SUITE_P(LongEnds, CheckPhases, testing::ValuesIn(cases_of_check_phases.others), name_of_check_phases);

TEST(LongCheckPhase, OfAModelThatCannotBeMadeIsNamed) {
  for (const char* deed : {"create abort", "create _exit", "create pause"}) {
    const Checked checked(deed);
    EXPECT_EQ(checked.ending.status, 1) << checked.ending.said;
    EXPECT_NE(checked.end().get<std::string>().find("when it was created"), std::string::npos) << checked.ending.said;
    EXPECT_TRUE(checked.nothing_is_left) << deed;
  }
  for (const char* deed : {"load abort", "unload abort"}) {
    const Checked checked(deed);
    const std::string when = std::string(deed).substr(0, std::string(deed).find(' '));
    EXPECT_EQ(checked.ending.status, 2) << checked.ending.said;
    EXPECT_NE(checked.ending.said.find(when + "ed"), std::string::npos) << checked.ending.said;
    EXPECT_EQ(std::count(checked.ending.said.begin(), checked.ending.said.end(), '\n'), 1) << checked.ending.said;
  }
}

}  // namespace
}  // namespace assay::drivers::test_check_phases
