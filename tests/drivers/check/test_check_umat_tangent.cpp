// SPDX-License-Identifier: BSD-3-Clause
// Slips of DDSDDE that a solver only feels: the stress is right.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/drivers/foreign_checks.hpp"
#include "tests/drivers/material/fortran_texts.hpp"
#include "tests/drivers/process.hpp"
#include "tests/support/some_of.hpp"

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

struct Found {
  std::string verdict, tangent;  ///< of the whole; the sentence of the tangent where it fails, or "passes"
};

Found checked(const std::string& source, const std::string& props) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("law.f", source);
  assay({"check", file, "--props", props, "--quick", "--json", scratch / "c.json", "-o", scratch / "r"});
  const auto found = nlohmann::json::parse(bytes_of(scratch / "c.json"));
  std::string sentence = "passes";
  for (const auto& test : found["tests"]) {
    if (test["id"] == "tangent" && test["verdict"] == "fail") sentence = test["sentence"];
  }
  return {found["verdict"], sentence};
}

struct Slip {
  const char *name, *statement, *skew, *words;
};

class UmatTangent : public testing::TestWithParam<Slip> {};

TEST_P(UmatTangent, IsNamedByWhatIsWrong) {
  if (!has_foreign("umat_kinematic")) GTEST_SKIP() << "no Fortran compiler";
  const std::string sentence = checked(umat(GetParam().statement, GetParam().skew), "1e3,.3").tangent;
  EXPECT_EQ(sentence.substr(0, std::string(GetParam().words).size()), GetParam().words);
}

const auto cases_of_umat_tangent = one_of_each<UmatTangent::ParamType>(
    3, testing::Values(Slip{"right", "      DDSDDE=C\n", "0.D0", "passes"},
                       Slip{"doubled", "      DDSDDE=2.D0*C\n", "0.D0", "the tangent is 2 times what it should be"},
                       Slip{"halved", "      DDSDDE=0.5D0*C\n", "0.D0", "the tangent is 0.5 times what it should be"},
                       Slip{"transposed", "      DDSDDE=TRANSPOSE(C)\n", "0.4D0", "the tangent is transposed"},
                       Slip{"not_symmetric", "      DDSDDE=C\n", "0.1D0", "passes"}));
const auto name_of_umat_tangent = [](const auto& instance) { return instance.param.name; };
INSTANTIATE_TEST_SUITE_P(Kinds, UmatTangent, testing::ValuesIn(cases_of_umat_tangent.some), name_of_umat_tangent);
INSTANTIATE_TEST_SUITE_P(LongKinds, UmatTangent, testing::ValuesIn(cases_of_umat_tangent.others), name_of_umat_tangent);

/// Rubber, W = C10 (I1 of the isochoric part - 3) + (J - 1)^2/D1, from DFGRD1; `shape` is a factor of what a change of
/// shape adds to DDSDDE, and the stress stays right.
std::string rubber(const std::string& shape) {
  return fixed_umat(
      "      DIMENSION B(3,3),D(3,3),II(6),JJ(6)\n"
      "      DATA II/1,2,3,1,1,2/, JJ/1,2,3,2,3,3/\n"
      "      D=0.D0\n"
      "      D(1,1)=1.D0\n"
      "      D(2,2)=1.D0\n"
      "      D(3,3)=1.D0\n"
      "      DET=DFGRD1(1,1)*(DFGRD1(2,2)*DFGRD1(3,3)-DFGRD1(2,3)*DFGRD1(3,2))\n"
      "     1   -DFGRD1(1,2)*(DFGRD1(2,1)*DFGRD1(3,3)-DFGRD1(2,3)*DFGRD1(3,1))\n"
      "     2   +DFGRD1(1,3)*(DFGRD1(2,1)*DFGRD1(3,2)-DFGRD1(2,2)*DFGRD1(3,1))\n"
      "      B=DET**(-2.D0/3.D0)*MATMUL(DFGRD1,TRANSPOSE(DFGRD1))\n"
      "      TRB=B(1,1)+B(2,2)+B(3,3)\n"
      "      EG=2.D0*PROPS(1)/DET\n"
      "      EK=2.D0/PROPS(2)*(2.D0*DET-1.D0)\n"
      "      DO 20 N=1,NTENS\n"
      "        I=II(N)\n"
      "        J=JJ(N)\n"
      "        STRESS(N)=EG*(B(I,J)-TRB/3.D0*D(I,J))\n"
      "     1    +2.D0/PROPS(2)*(DET-1.D0)*D(I,J)\n"
      "        DO 20 M=1,NTENS\n"
      "          K=II(M)\n"
      "          L=JJ(M)\n"
      "   20     DDSDDE(N,M)=" +
      shape +
      "*EG*(0.5D0*(D(I,K)*B(J,L)\n"
      "     1      +B(I,K)*D(J,L)+D(I,L)*B(J,K)+B(I,L)*D(J,K))\n"
      "     2      -2.D0/3.D0*(D(I,J)*B(K,L)+B(I,J)*D(K,L))\n"
      "     3      +2.D0/9.D0*TRB*D(I,J)*D(K,L))+EK*D(I,J)*D(K,L)\n");
}

struct RubberSlip {
  const char *name, *shape, *D1, *words;
};

class UmatTangentOfRubber : public testing::TestWithParam<RubberSlip> {};

/// K/G is 2/D1 with C10 = 0.5. Beside a bulk modulus that is a thousand times the shear modulus, no shear modulus at
/// all is some per mille of the largest component.
TEST_P(UmatTangentOfRubber, IsJudgedByItsShapeToo) {
  if (!has_foreign("umat_kinematic")) GTEST_SKIP() << "no Fortran compiler";
  const Found found = checked(rubber(GetParam().shape), std::string("0.5,") + GetParam().D1);
  EXPECT_EQ(found.tangent.substr(0, std::string(GetParam().words).size()), GetParam().words);
  EXPECT_EQ(found.verdict, found.tangent == "passes" ? "pass" : "fail");
}

const auto cases_of_umat_tangent_of_rubber = one_of_each<UmatTangentOfRubber::ParamType>(
    3,
    testing::Values(RubberSlip{"right_soft", "1.D0", "0.4", "passes"}, RubberSlip{"right", "1.D0", "0.002", "passes"},
                    RubberSlip{"right_hard", "1.D0", "2D-5", "passes"},
                    RubberSlip{"without_shape", "0.D0", "0.002", "the tangent of a change of shape is wrong by 100 %"},
                    RubberSlip{"half_a_shape", "0.5D0", "0.002", "the tangent of a change of shape is wrong by 50 %"},
                    RubberSlip{"doubled_shape", "2.D0", "2D-5", "the tangent of a change of shape is wrong by 100 %"}));
const auto name_of_umat_tangent_of_rubber = [](const auto& instance) { return instance.param.name; };
INSTANTIATE_TEST_SUITE_P(Kinds, UmatTangentOfRubber, testing::ValuesIn(cases_of_umat_tangent_of_rubber.some),
                         name_of_umat_tangent_of_rubber);
INSTANTIATE_TEST_SUITE_P(LongKinds, UmatTangentOfRubber, testing::ValuesIn(cases_of_umat_tangent_of_rubber.others),
                         name_of_umat_tangent_of_rubber);

/// The description does not say which strain it is for. By the wrong one the component that is farthest off would be
/// one that is right.
TEST(LongUmatOfRubber, AWrongTangentIsComparedWithTheNearerConvention) {
  if (!has_foreign("umat_kinematic")) GTEST_SKIP() << "no Fortran compiler";
  for (const char* shape : {"1.1D0", "0.93D0", "1.04D0"}) {
    const Found found = checked(rubber(shape), "0.5,0.4");
    EXPECT_EQ(found.verdict, "fail");
    EXPECT_NE(found.tangent.find("(by `strain: finite`, to which it is nearer"), std::string::npos) << found.tangent;
  }
}

/// One whose shears 13 and 23 are exchanged answers all six, so that a body of plane strain is no way out.
TEST(UmatOfRubber, WithExchangedShearsIsNotAdvisedToLeaveThemOut) {
  if (!has_foreign("umat_kinematic")) GTEST_SKIP() << "no Fortran compiler";
  const ScratchFolder scratch;
  std::string text = rubber("1.D0");
  const std::string right = "II/1,2,3,1,1,2/, JJ/1,2,3,2,3,3/", exchanged = "II/1,2,3,1,2,1/, JJ/1,2,3,2,3,3/";
  text.replace(text.find(right), right.size(), exchanged);
  const std::string source = scratch.write("rubber.f", text);
  const std::string file = scratch.write(
      "rubber.yaml", "source: rubber.f\ninterface: umat\nproperties: {C10: 0.5, D1: 0.4}\nstrain: finite\n");
  assay({"check", file, "--quick", "--json", scratch / "c.json", "-o", scratch / "r"});
  const auto found = nlohmann::json::parse(bytes_of(scratch / "c.json"));
  ASSERT_FALSE(found["diagnosis"].empty()) << source;
  EXPECT_EQ(found["diagnosis"][0]["cause"], "components 13 and 23 swapped");
  EXPECT_EQ(found["diagnosis"].dump().find("components: [4]"), std::string::npos) << found["diagnosis"].dump();
}

}  // namespace
}  // namespace assay::drivers::test_check_umat_tangent
