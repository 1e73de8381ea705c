// SPDX-License-Identifier: BSD-3-Clause
// Slips of sources that a user compiles and links without a warning, each beside the source that is right.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "harness/check/battery.hpp"
#include "tests/drivers/foreign_checks.hpp"
#include "tests/drivers/material/fortran_texts.hpp"
#include "tests/drivers/process.hpp"
#include "tests/support/some_of.hpp"

namespace assay::drivers::test_check_source_slips {
namespace {

std::string vumat(const std::string& statements) {
  return "      SUBROUTINE VUMAT(NBLOCK,NDIR,NSHR,NSTATEV,NFIELDV,NPROPS,LANNEAL,\n"
         "     1 STEPTIME,TOTALTIME,DT,CMNAME,COORDMP,CHARLENGTH,PROPS,DENSITY,\n"
         "     2 STRAININC,RELSPININC,TEMPOLD,STRETCHOLD,DEFGRADOLD,FIELDOLD,\n"
         "     3 STRESSOLD,STATEOLD,ENERINTERNOLD,ENERINELASOLD,TEMPNEW,\n"
         "     4 STRETCHNEW,DEFGRADNEW,FIELDNEW,STRESSNEW,STATENEW,ENERINTERNNEW,\n"
         "     5 ENERINELASNEW)\n"
         "      INCLUDE 'VABA_PARAM.INC'\n"
         "      CHARACTER*80 CMNAME\n"
         "      DIMENSION PROPS(NPROPS),STRAININC(NBLOCK,NDIR+NSHR),\n"
         "     1 STRESSOLD(NBLOCK,NDIR+NSHR),STATEOLD(NBLOCK,NSTATEV),\n"
         "     2 STRESSNEW(NBLOCK,NDIR+NSHR),STATENEW(NBLOCK,NSTATEV),S(6)\n" +
         statements + "      END\n";
}

/// Lamé's constants and, in what follows, the stiffness C of isotropic elasticity.
const std::string moduli =
    "      G=PROPS(1)/(2.D0*(1.D0+PROPS(2)))\n"
    "      ELAM=2.D0*G*PROPS(2)/(1.D0-2.D0*PROPS(2))\n";

/// As `moduli`, in the first call alone.
const std::string moduli_of_the_first_call =
    "      LOGICAL FIRST\n"
    "      SAVE FIRST,G,ELAM\n"
    "      DATA FIRST/.TRUE./\n"
    "      IF (FIRST) THEN\n" +
    moduli +
    "      FIRST=.FALSE.\n"
    "      END IF\n";

const std::string tangent =
    "      DDSDDE=0.D0\n"
    "      DDSDDE(1:3,1:3)=ELAM\n"
    "      DO 10 I=1,3\n"
    "        DDSDDE(I,I)=DDSDDE(I,I)+2.D0*G\n"
    "   10   DDSDDE(I+3,I+3)=G\n";
const std::string hooke = tangent + "      STRESS=STRESS+MATMUL(DDSDDE,DSTRAN)\n";

/// The stress of each point of a VUMAT; then more statements of the loop over K.
std::string points(const std::string& more) {
  return "      DO 20 K=1,NBLOCK\n"
         "        S=STRESSOLD(K,:)+2.D0*G*STRAININC(K,:)\n"
         "        S(1:3)=S(1:3)+ELAM*SUM(STRAININC(K,1:3))\n" +
         more +
         "        STRESSNEW(K,:)=S\n"
         "   20 CONTINUE\n";
}

const std::string fluid =
    "        S=STRESSOLD(K,:)\n"
    "        S(1:3)=S(1:3)+ELAM*SUM(STRAININC(K,1:3))\n";

/// A VUMAT that counts the work of extensions and of shears so many times.
std::string counting(const std::string& law, const char* extensions, const char* shears) {
  return vumat("      DIMENSION DENSITY(NBLOCK),ENERINTERNOLD(NBLOCK),ENERINTERNNEW(NBLOCK)\n" + moduli +
               points(law + "        W=" + extensions +
                      "*DOT_PRODUCT(STRESSOLD(K,1:3)+S(1:3),\n"
                      "     1    STRAININC(K,1:3))+" +
                      shears +
                      "*DOT_PRODUCT(STRESSOLD(K,4:6)+S(4:6),\n"
                      "     2    STRAININC(K,4:6))\n"
                      "        ENERINTERNNEW(K)=ENERINTERNOLD(K)+W/DENSITY(K)\n"));
}

/// Perfect plasticity, whose invariant weighs the shears so.
std::string plasticity(const std::string& weight) {
  return "        P=SUM(S(1:3))/3.D0\n"
         "        S(1:3)=S(1:3)-P\n"
         "        Q=SQRT(1.5D0*(SUM(S(1:3)**2)+" +
         weight +
         "*SUM(S(4:6)**2)))\n"
         "        IF (Q.GT.PROPS(3)) S=S*PROPS(3)/Q\n"
         "        S(1:3)=S(1:3)+P\n";
}

/// A viscosity of Perzyna's kind, the rate that of the beginning: of steps shorter than PROPS(4) alone.
const std::string explicit_flow = "      DIMENSION S(6)\n" + moduli + hooke +
                                  "      S=STRESS\n"
                                  "      S(1:3)=S(1:3)-SUM(STRESS(1:3))/3.D0\n"
                                  "      Q=SQRT(1.5D0*(SUM(S(1:3)**2)+2.D0*SUM(S(4:6)**2)))\n"
                                  "      IF (Q.GT.PROPS(3)) STRESS=STRESS\n"
                                  "     1 -3.D0*G*DTIME*(Q-PROPS(3))/PROPS(4)/Q*S\n";

/// A share of the stiffness that goes with the strain, and comes back with it.
const std::string healing = moduli + tangent +
                            "      DO 20 I=1,6\n"
                            "        EPS(I)=STRAN(I)+DSTRAN(I)\n"
                            "   20   V(I)=EPS(I)*(0.75D0+SIGN(0.25D0,3.5D0-I))\n"
                            "      EQ=SQRT(DOT_PRODUCT(EPS,V)+1.D-30)\n"
                            "      STRESS=EXP(-EQ/PROPS(3))*MATMUL(DDSDDE,EPS)\n"
                            "      DO 30 I=1,6\n"
                            "   30   DDSDDE(:,I)=EXP(-EQ/PROPS(3))*DDSDDE(:,I)-STRESS*V(I)/EQ/PROPS(3)\n";

/// The shear modulus goes with the volume, in increments.
const std::string pressed = moduli +
                            "      VOL=STRAN(1)+STRAN(2)+STRAN(3)\n"
                            "      G=G*(1.D0-PROPS(3)*VOL)\n" +
                            tangent + "      STRESS=STRESS+MATMUL(DDSDDE,DSTRAN)\n";

/// PROPS of a material are kept under its name, and found again by it.
const std::string kept_by_name =
    "      CHARACTER*80 NAMES(9)\n"
    "      DIMENSION KEPT(2,9)\n"
    "      SAVE NAMES,KEPT,NKEPT\n"
    "      DATA NKEPT/0/\n"
    "      K=1\n"
    "   40 IF (K.GT.NKEPT) THEN\n"
    "        NKEPT=K\n"
    "        NAMES(K)=CMNAME\n"
    "        KEPT(:,K)=PROPS(1:2)\n"
    "      ELSE IF (NAMES(K).NE.CMNAME) THEN\n"
    "        K=K+1\n"
    "        GOTO 40\n"
    "      END IF\n"
    "      G=KEPT(1,K)/(2.D0*(1.D0+KEPT(2,K)))\n"
    "      ELAM=2.D0*G*KEPT(2,K)/(1.D0-2.D0*KEPT(2,K))\n";

/// A neo-Hookean law of DFGRD1, whose components 4 to 6 are those of these tables of indices.
std::string neo_hookean_in_order(const std::string& rows, const std::string& columns) {
  return "      DIMENSION B(3,3),IA(6),IB(6),S(3,3),DK(3,3)\n"
         "      DATA IA/1,2,3," +
         rows + "/,IB/1,2,3," + columns + "/\n" + moduli +
         "      AJ=DFGRD1(1,1)*(DFGRD1(2,2)*DFGRD1(3,3)-DFGRD1(2,3)*DFGRD1(3,2))\n"
         "     1  -DFGRD1(1,2)*(DFGRD1(2,1)*DFGRD1(3,3)-DFGRD1(2,3)*DFGRD1(3,1))\n"
         "     2  +DFGRD1(1,3)*(DFGRD1(2,1)*DFGRD1(3,2)-DFGRD1(2,2)*DFGRD1(3,1))\n"
         "      B=MATMUL(DFGRD1,TRANSPOSE(DFGRD1))\n"
         "      DK=0\n"
         "      DO 10 I=1,3\n"
         "   10   DK(I,I)=1\n"
         "      S=(G*(B-DK)+ELAM*LOG(AJ)*DK)/AJ\n"
         "      A=ELAM/AJ\n"
         "      H=(G-ELAM*LOG(AJ))/AJ\n"
         "      DO 20 N=1,6\n"
         "        I=IA(N)\n"
         "        J=IB(N)\n"
         "        STRESS(N)=S(I,J)\n"
         "        DO 20 M=1,6\n"
         "          K=IA(M)\n"
         "          L=IB(M)\n"
         "   20     DDSDDE(N,M)=A*DK(I,J)*DK(K,L)\n"
         "     1      +H*(DK(I,K)*DK(J,L)+DK(I,L)*DK(J,K))\n"
         "     2      +.5D0*(DK(I,K)*S(J,L)+DK(J,K)*S(I,L)+DK(I,L)*S(J,K)\n"
         "     3      +DK(J,L)*S(I,K))\n";
}

/// The same law, right but for a component of stress and tangent that is so many times what it should be.
std::string neo_hookean_weighing(const std::string& component, const std::string& factor) {
  return neo_hookean_in_order("1,1,2", "2,3,3") + "      STRESS(" + component + ")=" + factor + "*STRESS(" + component +
         ")\n      DDSDDE(" + component + ",:)=" + factor + "*DDSDDE(" + component + ",:)\n";
}

/// The points of a VUMAT, but for those beyond that one.
std::string points_up_to(const std::string& last) {
  std::string text = points("");
  return text.replace(text.find("K=1,NBLOCK"), 10, "K=1," + last);
}

const std::string returns_when_held = "      IF (ALL(DSTRAN.EQ.0.D0)) RETURN\n";
const std::string returns_when_held_under_load = "      IF (ALL(DSTRAN.EQ.0.D0).AND.ANY(STRESS.NE.0.D0)) RETURN\n";

/// Plasticity with a back stress in STATEV(1:6), turned as a stress (1) or as a strain (2).
std::string back_stress(const std::string& kind) {
  return "      DIMENSION S(6),A(6)\n" + moduli + tangent + "      CALL ROTSIG(STATEV(1),DROT,A," + kind +
         ",3,3)\n"
         "      STRESS=STRESS+MATMUL(DDSDDE,DSTRAN)\n"
         "      S=STRESS\n"
         "      S(1:3)=S(1:3)-SUM(STRESS(1:3))/3.D0\n"
         "      S=S-A\n"
         "      Q=SQRT(1.5D0*(SUM(S(1:3)**2)+2.D0*SUM(S(4:6)**2)))\n"
         "      IF (Q.GT.PROPS(3)) THEN\n"
         "        DP=(Q-PROPS(3))/(3.D0*G+PROPS(4))\n"
         "        STRESS=STRESS-3.D0*G*DP*S/Q\n"
         "        A=A+PROPS(4)*DP*S/Q\n"
         "      END IF\n"
         "      STATEV(1:6)=A\n";
}

/// A stress that relaxes, kept in STATEV(1:6) besides.
std::string overstress(const std::string& kind) {
  return "      DIMENSION A(6),E(6)\n" + moduli + tangent + "      CALL ROTSIG(STATEV(1),DROT,A," + kind +
         ",3,3)\n"
         "      E=DSTRAN\n"
         "      E(1:3)=2.D0*(E(1:3)-SUM(DSTRAN(1:3))/3.D0)\n"
         "      X=EXP(-DTIME/PROPS(3))\n"
         "      STATEV(1:6)=X*(A+.5D0*G*E)\n"
         "      STRESS=STRESS-A+MATMUL(DDSDDE,DSTRAN)+STATEV(1:6)\n";
}

struct Source {
  std::string name, text;
  const char* properties;
  const char* cause;  // of the first diagnosis; empty: passes
  const char* words;  // in its sentence
  const char* statev = "";
};

void PrintTo(const Source& source, std::ostream* to) { *to << source.name; }

class SourceSlip : public testing::TestWithParam<Source> {};

/// A shear modulus that is missing makes no tangent that is transposed; and a cubic law in fixed axes lacks these
/// alone.
TEST(LongSourceSlips, OfAnisotropicModuliNameNoOtherCause) {
  if (!has_foreign("umat_kinematic")) GTEST_SKIP() << "no Fortran compiler";
  const ScratchFolder scratch;
  scratch.write("law.f", fixed_umat(moduli + tangent +
                                    "      DO 20 I=4,6\n   20   DDSDDE(I,I)=2.5D0*G\n"
                                    "      STRESS=STRESS+MATMUL(DDSDDE,DSTRAN)\n"));
  const auto said = [&](const std::string& keys) {
    const std::string file =
        scratch.write("law.yaml", "source: law.f\ninterface: umat\nproperties: [1e3, .3]\n" + keys);
    Ending check = assay({"check", file, "--quick", "-o", scratch / "r"});
    for (std::size_t at; (at = check.said.find("\n    ")) != std::string::npos;) check.said.replace(at, 5, " ");
    EXPECT_EQ(check.said.find("transposed"), std::string::npos) << check.said;
    EXPECT_EQ(check.said.find("shear factor 2"), std::string::npos) << check.said;
    return check;
  };
  for (const char* keys : {"", "symmetry: cubic\n"}) {
    const Ending check = said(keys);
    EXPECT_EQ(check.status, 1);
    EXPECT_NE(check.said.find("`axes: corotational`, with which it passes"), std::string::npos) << check.said;
  }
  EXPECT_EQ(said("symmetry: cubic\naxes: corotational\n").status, 0);
}

TEST_P(SourceSlip, IsNamed) {
  if (!has_foreign("umat_kinematic")) GTEST_SKIP() << "no Fortran compiler";
  const ScratchFolder scratch;
  const std::string file = scratch.write("law.f", GetParam().text);
  std::vector<std::string> words{
      "check", file, "--props", GetParam().properties, "--quick", "--json", scratch / "c.json", "-o", scratch / "r"};
  if (*GetParam().statev) words.insert(words.end(), {"--statev", GetParam().statev});
  const Ending check = assay(words);
  const bool is_right = *GetParam().cause == '\0';
  EXPECT_EQ(check.status, is_right ? 0 : 1) << check.said;
  const auto found = nlohmann::json::parse(bytes_of(scratch / "c.json"));
  ASSERT_EQ(found["diagnosis"].empty(), is_right) << check.said;
  if (is_right) return;
  EXPECT_EQ(found["diagnosis"][0]["cause"], GetParam().cause) << check.said;
  const std::string sentence = found["diagnosis"][0]["sentence"];
  EXPECT_NE(sentence.find(GetParam().words), std::string::npos) << sentence;
}

const auto cases_of_source_slip = one_of_each<SourceSlip::ParamType>(
    4,
    testing::Values(
        Source{"umat_right", fixed_umat(moduli + hooke), "1e3,.3", "", ""},
        Source{"umat_of_the_first_call", fixed_umat(moduli_of_the_first_call + hooke), "1e3,.3",
               check::causes::hidden_state, "of other parameters, the first of a process"},
        Source{"vumat_right", vumat(moduli + points("")), "1e3,.3", "", ""},
        Source{"vumat_of_the_first_call", vumat(moduli_of_the_first_call + points("")), "1e3,.3",
               check::causes::hidden_state, "of other parameters, the first of a process"},
        Source{"vumat_weighs_shears", vumat(moduli + points(plasticity("2.D0"))), "1e3,.3,1", "", ""},
        Source{"vumat_forgets_the_two", vumat(moduli + points(plasticity("1.D0"))), "1e3,.3,1",
               check::causes::not_isotropic, "not weighted as in an invariant"},
        Source{"vumat_weighs_shears_twice", vumat(moduli + points(plasticity("4.D0"))), "1e3,.3,1",
               check::causes::not_isotropic, "not weighted as in an invariant"},
        Source{"vumat_fluid", vumat(moduli + points(fluid)), "1e3,.3", "", ""},
        Source{"vumat_fluid_counts_its_work", counting(fluid, "0.5D0", "1.D0"), "1e3,.3", "", ""},
        Source{"vumat_counts_its_work", counting("", "0.5D0", "1.D0"), "1e3,.3", "", ""},
        Source{"vumat_counts_shears_by_half", counting("", "0.5D0", "0.5D0"), "1e3,.3", check::causes::energy,
               "counts the work of a shear 0.5 times"},
        Source{"vumat_counts_shears_alone", counting("", "0.D0", "1.D0"), "1e3,.3", check::causes::energy,
               "counts the work of a shear, and none of that of an extension"},
        Source{"vumat_counts_backwards", counting("", "-0.5D0", "-1.D0"), "1e3,.3", check::causes::energy,
               "enerInternNew falls when the stress does work"},
        Source{"shears_in_order", fixed_umat(neo_hookean_in_order("1,1,2", "2,3,3")), "1e3,.3", "", ""},
        Source{"shears_swapped", fixed_umat(neo_hookean_in_order("1,2,1", "2,3,3")), "1e3,.3",
               check::causes::components_swapped, "components 13 and 23 of stress or strain are exchanged"},
        Source{"shears_of_textbooks", fixed_umat(neo_hookean_in_order("2,1,1", "3,3,2")), "1e3,.3",
               check::causes::other_order, "are in the order 23, 13, 12, instead of 12, 13, 23"},
        Source{"shears_13_first", fixed_umat(neo_hookean_in_order("1,1,2", "3,2,3")), "1e3,.3",
               check::causes::other_order, "are in the order 13, 12, 23, instead of 12, 13, 23"},
        Source{"shears_moved_on", fixed_umat(neo_hookean_in_order("2,1,1", "3,2,3")), "1e3,.3",
               check::causes::other_order, "the shear components of the stress are in the order 23, 12, 13"},
        Source{"shears_of_the_strain",
               fixed_umat("      DIMENSION E(6)\n" + moduli + tangent +
                          "      E=DSTRAN\n      E(4)=DSTRAN(6)\n      E(6)=DSTRAN(4)\n"
                          "      STRESS=STRESS+MATMUL(DDSDDE,E)\n"),
               "1e3,.3", check::causes::other_order, "are in the order 23, 13, 12"},
        Source{"shear_23_doubled", fixed_umat(neo_hookean_weighing("6", "2.D0")), "1e3,.3", check::causes::shear_factor,
               "component 23 of stress or strain is doubled"},
        Source{"shear_13_halved", fixed_umat(neo_hookean_weighing("5", "0.5D0")), "1e3,.3", check::causes::shear_factor,
               "component 13 of stress or strain is halved"},
        Source{"shear_13_opposite", fixed_umat(neo_hookean_weighing("5", "(-1.D0)")), "1e3,.3",
               check::causes::wrong_sign, "component 13 of stress or strain is of the wrong sign"},
        Source{"normals_exchanged",
               fixed_umat(neo_hookean_in_order("1,1,2", "2,3,3") +
                          "      STRESS(2:3)=STRESS(3:2:-1)\n      DDSDDE(2:3,:)=DDSDDE(3:2:-1,:)\n"),
               "1e3,.3", check::causes::other_order, "components 22 and 33 of stress or strain are exchanged"},
        Source{"increments_of_shear_23_doubled",
               fixed_umat(moduli + tangent + "      DDSDDE(6,6)=2.D0*G\n      STRESS=STRESS+MATMUL(DDSDDE,DSTRAN)\n"),
               "1e3,.3", check::causes::shear_factor, "component 23 of stress or strain is doubled"},
        Source{"increments_of_shear_13_opposite",
               fixed_umat(moduli + tangent + "      DDSDDE(5,5)=-G\n      STRESS=STRESS+MATMUL(DDSDDE,DSTRAN)\n"),
               "1e3,.3", check::causes::wrong_sign, "component 13 of stress or strain is of the wrong sign"},
        Source{"cut_off_in_tension",
               fixed_umat(moduli + tangent +
                          "      STRESS=STRESS+MATMUL(DDSDDE,DSTRAN)\n"
                          "      P=SUM(STRESS(1:3))/3.D0\n"
                          "      IF (P.GT.1.D-3) THEN\n"
                          "        STRESS(1:3)=STRESS(1:3)-P+1.D-3\n"
                          "        DDSDDE(1:3,1:3)=DDSDDE(1:3,1:3)-ELAM-2.D0*G/3.D0\n"
                          "      END IF\n"),
               "1e3,.3", "", ""},
        Source{"constants_by_name", fixed_umat(kept_by_name + hooke), "1e3,.3", "", ""},
        Source{"heals", fixed_umat("      DIMENSION EPS(6),V(6)\n" + healing), "1e3,.3,.05", check::causes::dissipation,
               "a closed cycle of strains creates energy: "},
        Source{"shear_modulus_by_volume", fixed_umat(pressed), "1e3,.3,10", check::causes::dissipation,
               "a closed cycle of strains creates energy: "},
        Source{"leaves_short_steps_out",
               fixed_umat(moduli + tangent +
                          "      IF (SUM(ABS(DSTRAN)).LT.1.D-6) RETURN\n      STRESS=STRESS+MATMUL(DDSDDE,DSTRAN)\n"),
               "1e3,.3", check::causes::no_convergence,
               "the model skips small steps, so a slow loading adds no stress at all"},
        Source{"rests_when_held",
               fixed_umat(moduli + tangent +
                          "      STRESS=STRESS+MATMUL(DDSDDE,DSTRAN)\n"
                          "      IF (ALL(DSTRAN.EQ.0.D0)) RETURN\n"
                          "      X=EXP(-DTIME/PROPS(3))\n"
                          "      P=SUM(STRESS(1:3))/3.D0\n"
                          "      STRESS=X*STRESS\n"
                          "      STRESS(1:3)=STRESS(1:3)+(1.D0-X)*P\n"),
               "1e3,.3,1", check::causes::drifts, "the model skips steps without deformation"},
        Source{"explicit_flow", fixed_umat(explicit_flow), "1e3,.3,1,10", check::causes::dissipation,
               "The relaxation is integrated explicitly"},
        Source{"clock_in_the_stress", fixed_umat(moduli + hooke + "      STRESS(1)=STRESS(1)*(1.D0+TIME(1))\n"),
               "1e3,.3", check::causes::clock, ""},
        Source{"vumat_of_64_points", vumat(moduli + points_up_to("MIN(NBLOCK,64)")), "1e3,.3", check::causes::overrun,
               "leaves stressNew 11 unwritten, or computes it from itself, at point 65 of 128"},
        Source{"vumat_of_three_points", vumat(moduli + points_up_to("MIN(NBLOCK,3)")), "1e3,.3", check::causes::overrun,
               "leaves stressNew 11 unwritten, or computes it from itself, at point 4 of 7"},
        Source{"vumat_of_whole_fours", vumat(moduli + points_up_to("MAX(1,NBLOCK-MOD(NBLOCK,4))")), "1e3,.3",
               check::causes::overrun, "leaves stressNew 11 unwritten, or computes it from itself, at point 5 of 7"},
        Source{"no_moduli_at_rest", fixed_umat(returns_when_held + moduli + hooke), "1e3,.3",
               check::causes::tangent_wrong, "in a step without deformation"},
        Source{"no_moduli_when_held", fixed_umat(returns_when_held_under_load + moduli + hooke), "1e3,.3",
               check::causes::tangent_wrong, "in a step without deformation"},
        Source{"moduli_when_held",
               fixed_umat(moduli + tangent + returns_when_held + "      STRESS=STRESS+MATMUL(DDSDDE,DSTRAN)\n"),
               "1e3,.3", "", ""},
        Source{"back_stress_as_a_strain", fixed_umat(back_stress("2")), "1e3,.3,10,100", check::causes::shear_factor,
               "'STATEV(1:6)' of the state are doubled or halved", "6"},
        Source{"overstress_as_a_strain", fixed_umat(overstress("2")), "1e3,.3,10", check::causes::shear_factor,
               "'STATEV(1:6)' of the state are doubled or halved", "6"},
        Source{"back_stress_as_a_stress", fixed_umat(back_stress("1")), "1e3,.3,10,100", check::causes::tangent_wrong,
               "the tangent is the elastic tangent at rest", "6"},
        // 9.6 MB of the stack, which a thread of Abaqus has
        Source{"a_large_local_array",
               fixed_umat("      DIMENSION BIG(1200000)\n" + moduli + hooke +
                          "      BIG(KINC)=1.D0\n      BIG(1200000)=1.D0\n"
                          "      STRESS(1)=STRESS(1)*BIG(KINC)*BIG(1200000)\n"),
               "1e3,.3", "", ""}));
const auto name_of_source_slip = [](const auto& instance) { return instance.param.name; };
INSTANTIATE_TEST_SUITE_P(Kinds, SourceSlip, testing::ValuesIn(cases_of_source_slip.some), name_of_source_slip);
INSTANTIATE_TEST_SUITE_P(LongKinds, SourceSlip, testing::ValuesIn(cases_of_source_slip.others), name_of_source_slip);

}  // namespace
}  // namespace assay::drivers::test_check_source_slips
