// SPDX-License-Identifier: BSD-3-Clause
// Slips of DDSDDE that a solver only feels: the stress is right.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/drivers/foreign_checks.hpp"
#include "tests/drivers/material/fortran_texts.hpp"
#include "tests/drivers/process.hpp"

namespace assay::drivers::test_check_umat_tangent {
namespace {

/// STRESS + C DSTRAN of an elasticity whose stiffness need not be symmetric; then the slip.
std::string umat(const std::string& slip, const char* skew = "0.D0") {
  return fixed_umat(
      "      DIMENSION C(6,6)\n"
      "      EG=PROPS(1)/(2.D0*(1.D0+PROPS(2)))\n"
      "      C=0.D0\n"
      "      C(1:3,1:3)=2.D0*EG*PROPS(2)/(1.D0-2.D0*PROPS(2))\n"
      "      DO 10 I=1,3\n"
      "        C(I,I)=C(I,I)+2.D0*EG\n"
      "   10   C(I+3,I+3)=EG\n"
      "      C(1,2)=C(1,2)+" +
      std::string(skew) +
      "*EG\n"
      "      STRESS=STRESS+MATMUL(C,DSTRAN)\n" +
      slip);
}

struct Slip {
  const char *name, *statement, *skew, *words;
};

class UmatTangent : public testing::TestWithParam<Slip> {};

TEST_P(UmatTangent, IsNamedByWhatIsWrong) {
  if (!has_foreign("umat_kinematic")) GTEST_SKIP() << "no Fortran compiler";
  const ScratchFolder scratch;
  const std::string file = scratch.write("law.f", umat(GetParam().statement, GetParam().skew));
  assay({"check", file, "--props", "1e3,.3", "--quick", "--json", scratch / "c.json", "-o", scratch / "r"});
  std::string sentence = "passes";
  const auto found = nlohmann::json::parse(bytes_of(scratch / "c.json"));
  for (const auto& test : found["tests"]) {
    if (test["id"] == "tangent" && test["verdict"] == "fail") sentence = test["sentence"];
  }
  EXPECT_EQ(sentence.substr(0, std::string(GetParam().words).size()), GetParam().words);
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, UmatTangent,
    testing::Values(Slip{"right", "      DDSDDE=C\n", "0.D0", "passes"},
                    Slip{"doubled", "      DDSDDE=2.D0*C\n", "0.D0", "the tangent is 2 times what it should be"},
                    Slip{"halved", "      DDSDDE=0.5D0*C\n", "0.D0", "the tangent is 0.5 times what it should be"},
                    Slip{"transposed", "      DDSDDE=TRANSPOSE(C)\n", "0.4D0", "the tangent is transposed"},
                    Slip{"not_symmetric", "      DDSDDE=C\n", "0.1D0", "passes"}),
    [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace assay::drivers::test_check_umat_tangent
