// SPDX-License-Identifier: BSD-3-Clause
// What the author of a source has not declared, and `check` finds by trying.
#include "drivers/check/check_foreign.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/drivers/material/source_fixture.hpp"
#include "tests/drivers/process.hpp"

namespace assay::drivers::test_check_undeclared {
namespace {

class CheckUndeclared : public SourceTest {
 protected:
  struct Found {
    int status;
    std::string said;  ///< in one line
    nlohmann::json json;
    std::string cause() const { return json["diagnosis"].empty() ? "none" : json["diagnosis"][0]["cause"]; }
    bool says(const std::string& words) const { return said.find(words) != std::string::npos; }
  };

  Found check(const std::string& model, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"check", model, "--quick", "--json", "found.json", "-o", "results"};
    words.insert(words.end(), more.begin(), more.end());
    const Ending ending = assay(words, [&] {
      if (::chdir((scratch / "").c_str()) != 0) ::_exit(126);
    });
    Found found{ending.status, {}, {}};
    for (const char c : ending.said) {
      if (!(c == ' ' && found.said.ends_with(' '))) found.said += c == '\n' ? ' ' : c;
    }
    for (std::size_t at; (at = found.said.find("  ")) != std::string::npos;) found.said.erase(at, 1);
    if (std::filesystem::exists(scratch / "found.json")) {
      found.json = nlohmann::json::parse(bytes_of(scratch / "found.json"));
    }
    return found;
  }
};
using LongCheckUndeclared = CheckUndeclared;

/// Hooke's law whose deviator relaxes, in PROPS(3) seconds.
const std::string relaxing_statements = hooke_statements +
                                        "      P=(STRESS(1)+STRESS(2)+STRESS(3))/3.D0\n"
                                        "      W=EXP(-DTIME/PROPS(3))\n"
                                        "      DO I=1,NTENS\n"
                                        "        IF (I.LE.3) STRESS(I)=P+(STRESS(I)-P)*W\n"
                                        "        IF (I.GT.3) STRESS(I)=STRESS(I)*W\n"
                                        "        DO J=1,NTENS\n"
                                        "          IF (I.GT.3) DDSDDE(I,J)=DDSDDE(I,J)*W\n"
                                        "        END DO\n"
                                        "      END DO\n"
                                        "      DO I=1,3\n"
                                        "        D=(DDSDDE(1,I)+DDSDDE(2,I)+DDSDDE(3,I))/3.D0\n"
                                        "        DO J=1,3\n"
                                        "          DDSDDE(J,I)=D+(DDSDDE(J,I)-D)*W\n"
                                        "        END DO\n"
                                        "      END DO\n";

TEST_F(LongCheckUndeclared, DependenceOnTheRateIsTriedAndTold) {
  scratch.write("model.f", fixed_umat(relaxing_statements));
  const Found found = check("model.f", {"--props", "210e3,.3,.5"});
  EXPECT_EQ(found.status, 0) << found.said;
  EXPECT_TRUE(found.says("depends on the rate (")) << found.said;
  EXPECT_TRUE(found.says("flags: [rate_dependent] declares it")) << found.said;
  EXPECT_EQ(found.json["depends_on"][0]["on"], "the rate");
}

TEST_F(LongCheckUndeclared, WhoHasDeclaredFlagsIsTakenAtHisWord) {
  scratch.write("model.f", fixed_umat(relaxing_statements));
  scratch.write("said.yaml", "source: model.f\ninterface: umat\nproperties: [210e3, 0.3, 0.5]\nflags: []\n");
  const Found found = check("said.yaml");
  EXPECT_EQ(found.status, 1) << found.said;
  EXPECT_EQ(found.cause(), check::causes::clock) << found.said;
  scratch.write("rate.yaml",
                "source: model.f\ninterface: umat\nproperties: [210e3, 0.3, 0.5]\nflags: [rate_dependent]\n");
  const Found declared = check("rate.yaml");
  EXPECT_EQ(declared.status, 0) << declared.said;
  EXPECT_FALSE(declared.says("depends on the rate")) << "it is declared";
}

/// DTIME is a clock of its own here: no law of the rate.
TEST_F(LongCheckUndeclared, AnotherUseOfTheClockStaysADefect) {
  scratch.write("model.f", fixed_umat(hooke_statements + "      STRESS(1)=STRESS(1)+1.D-3*PROPS(1)*DTIME\n"));
  const Found found = check("model.f", {"--props", "210e3,.3"});
  EXPECT_EQ(found.status, 1) << found.said;
}

TEST_F(LongCheckUndeclared, AFailureBesideTheRateIsNamedAloneAndReplayedAlike) {
  scratch.write("model.f", fixed_umat(relaxing_statements + "      STRESS(4)=STRESS(4)+0.05D0*PROPS(1)*DSTRAN(4)\n"));
  const Found found = check("model.f", {"--props", "210e3,.3,.5"});
  EXPECT_EQ(found.status, 1) << found.said;
  EXPECT_NE(found.cause(), check::causes::clock) << found.said;
  EXPECT_TRUE(found.says("depends on the rate (")) << found.said;
  for (const auto& test : found.json["tests"]) {
    if (test["verdict"] != "fail") continue;
    const Ending again = assay({"check", "--replay", scratch / test["replay"].get<std::string>()}, [&] {
      if (::chdir((scratch / "").c_str()) != 0) ::_exit(126);
    });
    EXPECT_EQ(again.status, 1) << test["id"] << again.said;
    EXPECT_EQ(again.said.find("diagnosis: clock"), std::string::npos) << test["id"] << again.said;
  }
}

const std::string fibre_statements = hooke_statements +
                                     "      STRESS(1)=STRESS(1)+PROPS(1)*DSTRAN(1)\n"
                                     "      DDSDDE(1,1)=DDSDDE(1,1)+PROPS(1)\n";

TEST_F(CheckUndeclared, DirectionsAreAskedForAndNotTakenForGranted) {
  scratch.write("model.f", fixed_umat(fibre_statements));
  const Found found = check("model.f", {"--props", "210e3,.3"});
  EXPECT_EQ(found.status, 1) << found.said;
  EXPECT_TRUE(found.says("no symmetry is declared, so it was tested as isotropic")) << found.said;
  EXPECT_TRUE(found.says("`symmetry: anisotropic`")) << found.said;
  scratch.write("said.yaml", "source: model.f\ninterface: umat\nproperties: [210e3, 0.3]\nsymmetry: isotropic\n");
  EXPECT_FALSE(check("said.yaml").says("no symmetry is declared")) << "it is declared";
}

/// STRESS(1:3) of 11, 22 and 12.
TEST_F(LongCheckUndeclared, PlaneStressIsToldAndJudgedWhereItIsDeclared) {
  const std::string statements =
      "      DDSDDE(1:3,1:3)=0\n      F=PROPS(1)/(1-PROPS(2)**2)\n      DDSDDE(1,1)=F\n      DDSDDE(2,2)=F\n"
      "      DDSDDE(1,2)=F*PROPS(2)\n      DDSDDE(2,1)=F*PROPS(2)\n      DDSDDE(3,3)=F*(1-PROPS(2))/2\n"
      "      DO I=1,3\n        DO J=1,3\n          STRESS(I)=STRESS(I)+DDSDDE(I,J)*DSTRAN(J)\n        END DO\n"
      "      END DO\n";
  scratch.write("model.f", fixed_umat(statements));
  const Found found = check("model.f", {"--props", "210e3,.3"});
  EXPECT_EQ(found.status, 2) << found.said;
  EXPECT_TRUE(found.says("as in plane stress (11, 22 and 12)")) << found.said;
  const std::string keys = "source: model.f\ninterface: umat\nproperties: [210e3, 0.3]\ncomponents: ";
  for (const char* said : {"[6]\n", "[4]\n", "[4]\nsymmetry: anisotropic\naxes: corotational\n"}) {
    scratch.write("said.yaml", keys + said);
    const Found declared = check("said.yaml");
    EXPECT_EQ(declared.status, 2) << said << declared.said;
    EXPECT_TRUE(declared.says("as in plane stress (11, 22 and 12)")) << said << declared.said;
    EXPECT_TRUE(declared.says("declare components: [3]")) << said << declared.said;
  }
  scratch.write("said.yaml", keys + "[3]\nthickness: 0.3\n");
  const Found judged = check("said.yaml");
  EXPECT_EQ(judged.status, 0) << judged.said;
}

}  // namespace
}  // namespace assay::drivers::test_check_undeclared
