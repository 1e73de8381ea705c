// SPDX-License-Identifier: BSD-3-Clause
// MTest files that are wrong: each gives one line, with the place.
#include <gtest/gtest.h>

#include <random>

#include "drivers/point_drivers/mtest_file.hpp"
#include "tests/drivers/refusal.hpp"

namespace assay::drivers::test_mtest_damage {
namespace {

std::string refused_text(const std::string& text) {
  return refusal_of([&] { mtest_from_text(text, "a.mtest"); });
}

/// What is refused of lines of which the first one is line 3.
std::string refused(const std::string& lines) {
  return refused_text("@Behaviour<generic> 'law.so' 'Law';\n@Times {0, 1};\n" + lines);
}

TEST(MtestDamage, WhatIsMissingIsNamed) {
  EXPECT_EQ(refused_text(""), "a.mtest: @Behaviour: required and not given");
  EXPECT_EQ(refused_text("@Behaviour 'l' 'f';\n"), "a.mtest: @Times: required and not given");
  EXPECT_EQ(refused("@Real 'a' 1"), "a.mtest:3:12: @Real: ';' is missing: the file ends");
  EXPECT_EQ(refused("@Real 'a' 1\n@Real 'b' 2;"), "a.mtest:4:1: @Real: ';' is missing: found @Real");
  EXPECT_EQ(refused("@Real a 1;"), "a.mtest:3:7: @Real: a text in quotes is missing: found a");
  EXPECT_EQ(refused("@Real 'a';"), "a.mtest:3:10: @Real: a number is missing: found ;");
  EXPECT_EQ(refused("@Description {"), "a.mtest:3:14: @Description: '{' without '}'");
  EXPECT_EQ(refused("/* x"), "a.mtest:3:1: a remark that begins with /* and does not end");
}

TEST(MtestDamage, UnknownWordsGetTheNearestOne) {
  EXPECT_TRUE(
      refused("@ImposedStran 'EXX' 0;").starts_with("a.mtest:3:1: unknown keyword (nearest: @ImposedStrain); known: "))
      << refused("@ImposedStran 'EXX' 0;");
  EXPECT_TRUE(refused("ImposedStrain 'EXX' 0;").starts_with("a.mtest:3:1: a keyword as @Times belongs here, found "));
  EXPECT_EQ(refused("@ImposedStrain 'EXW' 0;"),
            "a.mtest:3:16: @ImposedStrain: unknown component (nearest: EXX) of the hypothesis Tridimensional; known: "
            "EXX, EYY, EZZ, EXY, EXZ, EYZ");
  EXPECT_EQ(refused("@ModellingHypothesis 'Axisymetrical';"),
            "a.mtest:3:22: @ModellingHypothesis: unknown hypothesis (nearest: Axisymmetrical); known: "
            "AxisymmetricalGeneralisedPlaneStrain, AxisymmetricalGeneralisedPlaneStress, Axisymmetrical, PlaneStress, "
            "PlaneStrain, GeneralisedPlaneStrain, Tridimensional");
  EXPECT_EQ(refused("@Real 'ab' 1;\n@Evolution<function> 'c' 'abb + t';"),
            "a.mtest:4:27: unknown name in a formula (nearest: ab); known: ab, c");
  EXPECT_EQ(refused("@Test<fil> 'r' {'a' : 1} 1;"), "a.mtest:3:6: @Test: write @Test<function> or @Test<file>");
}

TEST(MtestDamage, WhatIsNotServedIsSaid) {
  EXPECT_EQ(refused("@ImposedOpeningDisplacement 'Un' 0;"),
            "a.mtest:3:29: @ImposedOpeningDisplacement: cohesive zone models are not served");
  EXPECT_EQ(refused("@Import<castem> 'lib' 'f';"),
            "a.mtest:3:8: @Import: functions of libraries are not served in formulas: write the formula out");
  EXPECT_EQ(refused("@ImposedStrain 'EXX' 0 {active : false};"),
            "a.mtest:3:24: @ImposedStrain: events that switch what is imposed on and off are not served");
}

TEST(MtestDamage, ValuesThatCannotBeAreRefused) {
  EXPECT_EQ(refused("@Real 'a' 1e999;"), "a.mtest:3:11: @Real: '1e999' is no number within the range of a double");
  EXPECT_EQ(refused("@Real 't' 1;"), "a.mtest:3:7: @Real: 't' is the time");
  EXPECT_EQ(refused("@Real 'exp' 1;"), "a.mtest:3:7: @Real: 'exp' is a function of formulas");
  EXPECT_EQ(refused("@Real 'a' 1;\n@Evolution 'a' 2;"), "a.mtest:4:12: @Evolution: 'a' is there already, in line 3");
  EXPECT_EQ(refused("@Evolution<function> 'a' 't';\n@Real 'b' 'a';"),
            "a.mtest:4:12: @Real: 'a' depends on the time, where one number is wanted");
  EXPECT_EQ(refused("@Evolution<function> 'a' 'b';\n@Evolution<function> 'b' 'a+1';"),
            "a.mtest:4:27: 'a' calls itself through this formula");
  EXPECT_EQ(refused("@Evolution 'a' {0 : 1, 0 : 2};"), "a.mtest:3:24: @Evolution: the time 0 is there twice");
  EXPECT_EQ(refused("@Test<function> 'SXX' '0' -1;"), "a.mtest:3:27: @Test: the tolerance must not be negative");
  EXPECT_EQ(refused("@StressEpsilon 0;"), "a.mtest:3:16: @StressEpsilon: must be positive");
  EXPECT_EQ(refused("@MaximumNumberOfSubSteps 0;"), "a.mtest:3:26: @MaximumNumberOfSubSteps: must be at least 1");
  EXPECT_EQ(refused("@RotationMatrix {{1, 0, 0}, {0, 1, 0}, {0, 0, 2}};"),
            "a.mtest:3:17: @RotationMatrix: no rotation: the scalar product of the columns 3 and 3 is 4");
  EXPECT_EQ(refused("@RotationMatrix {1, 0};"), "a.mtest:3:17: @RotationMatrix: 9 numbers are needed");
  EXPECT_EQ(refused("@ExternalStateVariable 'v' {1, 2};"),
            "a.mtest:3:24: @ExternalStateVariable: 2 values make no vector or tensor of the hypothesis Tridimensional");
  EXPECT_EQ(refused("@ImposedStrain 'EXX' 0;\n@Strain {1, 2};"),
            "a.mtest: @Strain: has 2 initial values, where the hypothesis Tridimensional has 6 components");
  EXPECT_EQ(refused("@ImposedStrain 'EXX' 0;\n@ImposedGradient 'FXX' 0;"),
            "a.mtest:4:18: strains and deformation gradients are imposed in one file");
}

TEST(MtestDamage, TimesMustAscend) {
  const auto line = [](const std::string& times) { return refused_text("@Behaviour 'l' 'f';\n@Times " + times + ";"); };
  EXPECT_EQ(line("{0, 1, 1}"), "a.mtest:2:15: @Times: the times must ascend");
  EXPECT_EQ(line("{0, 1 in 0}"), "a.mtest:2:17: @Times: at least one interval");
  EXPECT_EQ(line("{0, 1 in 2000000000}"), "a.mtest:2:17: @Times: too many times");
  EXPECT_EQ(line("{0}"), "a.mtest:2:8: @Times: at least two times are needed");
  EXPECT_EQ(line("{}"), "a.mtest:2:9: @Times: a number is missing: found }");
}

TEST(MtestDamage, PlaceholdersNeedValues) {
  EXPECT_EQ(refused("@MaterialProperty<castem> 'E' @mplibrary@ 'f';"),
            "a.mtest:3:31: @MaterialProperty: no value is given for @mplibrary@");
}

const std::string whole =
    "@Author A;\n@Description { \"text\" };\n@ModellingHypothesis 'Tridimensional';\n"
    "@Behaviour<generic> 'l.so' 'Law' {stress_measure : 'PK1'};\n"
    "@MaterialProperty<constant> 'E' 70e9;\n@Real 'a' '2*E';\n@Evolution<function> 'b' 'a*sin(t)**2';\n"
    "@ExternalStateVariable 'Temperature' {0 : 300, 1 : 400};\n@InternalStateVariable 'p' {1, {2, 3}};\n"
    "@ImposedDeformationGradient 'FXX' {0 : 1, 1 : 1.1};\n@ImposedStress<function> 'SYY' 'b';\n"
    "@RotationMatrix<Euler> {0.1, 0.2, 0.3};\n@NonLinearConstraint<Stress> 'SZZ - SYY';\n@Times {0, 1 in 10};\n"
    "@Test<function> {'SXX' : 'b', 'SZZ' : '0'} 1e-3;\n@Test<file> 'r.txt' {'SXX' : 2} 1;\n";

/// One line that names the file, or nothing to refuse.
void expect_one_line(const std::string& text) {
  const std::string line = refused_text(text);
  EXPECT_EQ(line.find('\n'), line.npos) << text;
  EXPECT_TRUE(line == "accepted" || line.starts_with("a.mtest")) << line;
}

TEST(MtestDamage, AFileThatIsCutGivesOneLine) {
  EXPECT_EQ(refused_text(whole), "accepted");
  for (std::size_t size = 0; size < whole.size(); ++size) expect_one_line(whole.substr(0, size));
}

TEST(MtestDamage, DamagedBytesGiveOneLine) {
  std::mt19937 random(7);
  for (int i = 0; i < 4000; ++i) {
    std::string text = whole;
    for (unsigned hits = 1 + random() % 4; hits > 0; --hits) {
      const std::size_t at = random() % text.size();
      switch (random() % 3) {
        case 0:
          text[at] = static_cast<char>(random() % 256);
          break;
        case 1:
          text.erase(at, 1 + random() % 20);
          break;
        default:
          text.insert(at, text.substr(random() % text.size(), random() % 20));
      }
    }
    expect_one_line(text);
  }
}

TEST(MtestDamage, DeepFormulasAndLongChainsEnd) {
  std::string chain;
  for (int i = 0; i < 3000; ++i)
    chain += "@Evolution<function> 'a" + std::to_string(i) + "' 'a" + std::to_string(i + 1) + "';\n";
  EXPECT_NE(refused(chain + "@Real 'a3000' 1;\n").find("a chain of too many formulas"), std::string::npos);
  EXPECT_NE(refused("@InternalStateVariable 'p' " + std::string(100000, '{')).find("a number is missing"),
            std::string::npos);
}

}  // namespace
}  // namespace assay::drivers::test_mtest_damage
