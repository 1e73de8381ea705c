// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/point_drivers/mtest_file.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/drivers/refusal.hpp"
#include "tests/drivers/scratch_folder.hpp"

namespace assay::drivers::test_mtest_file {
namespace {

using Quantity = MtestImposed::Quantity;

const std::string behaviour = "@Behaviour<generic> 'law.so' 'Law';\n";
const std::string times = "@Times {0, 1 in 4};\n";

MtestFile read(const std::string& lines) { return mtest_from_text(behaviour + times + lines, "a.mtest"); }

/// What is refused of lines of which the first one is line 3.
std::string refused(const std::string& lines) {
  return refusal_of([&] { read(lines); });
}

TEST(MtestFile, AWholeFileIsTaken) {
  const MtestFile file = mtest_from_text(
      "@Author A. Person;\n"
      "@Date 1 / 2 / 2026;\n"
      "@Description {\n  It's {nested}, \"as written\".\n};\n"
      "@ModellingHypothesis 'PlaneStrain';\n"
      "@Behaviour<@interface@, Wrapper> @library@ 'Law' {stress_measure : 'PK1', list : {'a', 'b'}};\n"
      "@MaterialProperty<constant> 'E' 70e9;  // [Pa]\n"
      "@MaterialProperty<function> 'nu' '0.3 + t/100';\n"
      "@Parameter 'eps' 1e-9;\n@IntegerParameter 'most' -12;\n"
      "@ExternalStateVariable 'Temperature' {0 : 293.15, 2 : '2*293.15'};\n"
      "/* over\n lines */ @InternalStateVariable 'El' {1, -2, '1+2', 0};\n"
      "@StateVariable 'p' 0.25;\n"
      "@Strain {1e-3, 0, 0, 0};\n@Stress {5, 0, 0, 0};\n"
      "@ImposedStrain<function> 'EXX' '1e-3*t';\n"
      "@ImposedStress 'SYY' -5;\n"
      "@StrainEpsilon 1e-12;\n@StressEpsilon 10;\n"
      "@MaximumNumberOfSubSteps 3;\n@MaximumNumberOfIterations 50;\n"
      "@AccelerationAlgorithm 'Cast3M';\n@OutOfBoundsPolicy 'Strict';\n@HandleThermalExpansion false;\n"
      "@Times {0., 1. in 2, 3};\n;\n",
      "a.mtest", {{{"interface", "castem"}, {"library", "'libLaw.so'"}}, {}});
  EXPECT_EQ(file.author, "A. Person");
  EXPECT_EQ(file.date, "1 / 2 / 2026");
  EXPECT_EQ(file.description, "It's {nested}, \"as written\".");
  EXPECT_EQ(file.hypothesis, "PlaneStrain");
  EXPECT_EQ(file.behaviour.interface, "castem");
  EXPECT_EQ(file.behaviour.wrapper, "Wrapper");
  EXPECT_EQ(file.behaviour.library, "libLaw.so");
  EXPECT_EQ(file.behaviour.function, "Law");
  EXPECT_EQ(file.behaviour.options.at("stress_measure"), "PK1");
  EXPECT_EQ(file.behaviour.options.at("list"), "a, b");
  ASSERT_EQ(file.properties.size(), 2u);
  EXPECT_EQ(file.properties[0].value(7), 70e9);
  EXPECT_TRUE(file.properties[0].value.is_constant());
  EXPECT_EQ(file.properties[1].value(10), 0.3 + 10.0 / 100);
  ASSERT_EQ(file.parameters.size(), 2u);
  EXPECT_EQ(file.parameters[1].value, -12);
  ASSERT_EQ(file.external.size(), 1u);
  EXPECT_EQ(file.external[0].value(1), 1.5 * 293.15);
  EXPECT_EQ(file.external[0].value.knots(), (std::vector<double>{0, 2}));
  ASSERT_EQ(file.initial_state.size(), 2u);
  EXPECT_EQ(file.initial_state[0].values, (std::vector<double>{1, -2, 3, 0}));
  EXPECT_TRUE(file.initial_state[0].in_braces);
  EXPECT_FALSE(file.initial_state[1].in_braces);
  EXPECT_EQ(file.initial_gradient.size(), 4u);
  EXPECT_EQ(file.initial_force[0], 5);
  ASSERT_EQ(file.imposed.size(), 2u);
  EXPECT_EQ(file.imposed[0].quantity, Quantity::strain);
  EXPECT_EQ(file.imposed[1].quantity, Quantity::stress);
  EXPECT_EQ(file.imposed[1].value(0), -5);
  EXPECT_EQ(file.kinematics, MtestKinematics::small_strain);
  EXPECT_EQ(file.strain_epsilon, 1e-12);
  EXPECT_EQ(file.stress_epsilon, 10);
  EXPECT_EQ(file.most_substeps, 3);
  EXPECT_EQ(file.most_iterations, 50);
  EXPECT_EQ(file.times, (std::vector<double>{0, 0.5, 1, 3}));
  EXPECT_EQ(file.out_of_bounds, "Strict");
  EXPECT_FALSE(file.thermal_expansion);
  ASSERT_EQ(file.ignored.size(), 2u);
  const bool first = file.ignored[0].keyword == "@AccelerationAlgorithm";
  EXPECT_EQ(file.ignored[first ? 0 : 1].what, "'Cast3M': how the solver of MTest converges");
  EXPECT_EQ(file.ignored[first ? 1 : 0].keyword, "@OutOfBoundsPolicy");
}

TEST(MtestFile, FormulasNameWhatComesLater) {
  const MtestFile file = read(
      "@Evolution<function> 'a' 'b + 2*EXX';\n"
      "@Evolution 'b' {0 : 1, 0.5 : 3};\n"
      "@ImposedStrain 'EXX' {0 : 0, 0.25 : 1, 1 : 0};\n"
      "@Test<function> 'SXX' 'a**2' 1e-3;\n");
  const FunctionOfTime& a = file.evolutions.at("a");
  EXPECT_EQ(a(0.25), 4);
  EXPECT_EQ(a.knots(), (std::vector<double>{0, 0.25, 0.5, 1}));
  EXPECT_FALSE(a.is_constant());
  ASSERT_EQ(file.comparisons.size(), 1u);
  EXPECT_EQ(file.comparisons[0].expected(0.25), 16);
  EXPECT_EQ(file.comparisons[0].expected.knots(), a.knots());
}

TEST(MtestFile, ConstantsAreNumbers) {
  const MtestFile file = read(
      "@Real 'R' '2*3';\n@Evolution<function> 'S' 'R+1';\n@Evolution 'one' {5 : 4};\n"
      "@ImposedStress 'SXX' 'R*S + one';\n");
  EXPECT_EQ(file.imposed[0].value(0), 46);
}

TEST(MtestFile, ComponentsOfVariablesAreNamed) {
  const MtestFile file = read(
      "@ExternalStateVariable<function> 'v[1]' {'5*t', '2', '3 * t'};\n"
      "@ExternalStateVariable 's' {1, {0 : 0, 1 : 2}, 3, 4, 5, 6};\n"
      "@ExternalStateVariable<function> 'F' {'1','2','3','4','5','6','7','8','9'};\n"
      "@Test<function> {'a' : 'v[1]Z + sYY', 'b' : '-t'} 0.5;\n");
  ASSERT_EQ(file.external.size(), 18u);
  EXPECT_EQ(file.external[2].name, "v[1]Z");
  EXPECT_EQ(file.external[8].name, "sYZ");
  EXPECT_EQ(file.external[17].name, "FZY");
  ASSERT_EQ(file.comparisons.size(), 2u);
  EXPECT_EQ(file.comparisons[0].expected(1), 5);
  EXPECT_EQ(file.comparisons[1].expected(1), -1);
  EXPECT_EQ(file.comparisons[1].tolerance, 0.5);
}

TEST(MtestFile, WhatIsImposedSaysTheKinematics) {
  EXPECT_EQ(read("@ImposedDeformationGradient 'FXY' 0;\n").kinematics, MtestKinematics::finite_strain);
  EXPECT_EQ(read("@ImposedDrivingVariable 'FXX' 1;\n").imposed[0].quantity, Quantity::deformation_gradient);
  EXPECT_EQ(read("@ImposedGradient 'EXY' 1;\n").kinematics, MtestKinematics::small_strain);
  EXPECT_EQ(read("@ImposedGradient 'Potential' 1;\n").kinematics, MtestKinematics::other);
  EXPECT_EQ(read("@ImposedThermodynamicForce 'SXX' 1;\n").imposed[0].quantity, Quantity::stress);
  EXPECT_EQ(read("@ImposedThermodynamicForce 'Flux' 1;\n").imposed[0].quantity, Quantity::force);
  EXPECT_EQ(read("@ImposedStress 'SXX' 1;\n").kinematics, MtestKinematics::unknown);
  EXPECT_EQ(read("@Gradient {1, 1, 1, 0, 0, 0, 0, 0, 0};\n").kinematics, MtestKinematics::finite_strain);
  EXPECT_EQ(read("@ModellingHypothesis 'Axisymmetrical';\n@ImposedStrain 'ERZ' 1;\n").imposed[0].component, "ERZ");
}

TEST(MtestFile, AConstraintHoldsFreeComponents) {
  const MtestFile file =
      read("@Real 'A' 0.5;\n@ImposedStrain 'EXX' '0.1';\n@NonLinearConstraint<Stress> 'SYY - A*SXX + EXX*t';\n");
  ASSERT_EQ(file.constraints.size(), 1u);
  const MtestConstraint& constraint = file.constraints[0];
  EXPECT_TRUE(constraint.is_of_stress);
  EXPECT_EQ(constraint.components, (std::vector<std::string>{"SYY", "SXX"}));
  EXPECT_EQ(constraint.value({7, 4}, 10), 7 - 0.5 * 4 + 0.1 * 10);
}

TEST(MtestFile, RotationsHaveTheDirectionsAsColumns) {
  const MtestFile matrix = read("@Real 'c' 0;\n@RotationMatrix {{'c', -1, 0}, {1, 0, 0}, {0, 0, 1}};\n");
  EXPECT_EQ(matrix.rotation, (std::array<double, 9>{0, -1, 0, 1, 0, 0, 0, 0, 1}));
  const MtestFile directions = read("@RotationMatrix<Direction> {{0, 2, 0}, {3, 1, 0}};\n");
  EXPECT_EQ(directions.rotation, (std::array<double, 9>{0, 1, 0, 1, 0, 0, 0, 0, -1}));
  const MtestFile miller = read("@RotationMatrix<Miller> {1, 2, 2};\n");
  EXPECT_NEAR(miller.rotation[6], 1. / 3, 1e-15);
  EXPECT_NEAR(miller.rotation[8], 2. / 3, 1e-15);
  const MtestFile euler = read("@RotationMatrix<Euler> {0.3, 0.2, 0.1};\n");
  EXPECT_NEAR(euler.rotation[8], std::cos(0.2), 1e-15);
  EXPECT_TRUE(euler.is_rotated);
}

TEST(MtestFile, ColumnsOfFilesAreRead) {
  const ScratchFolder scratch;
  scratch.write("r.txt", "# time strain stress\n0 0 0\n\n1 2 30 # a remark\n2 4 50\n");
  const std::string name = scratch.write("a.mtest", behaviour +
                                                        "@Times<data> 'r.txt' using 1;\n@Real 'k' 10;\n"
                                                        "@Evolution<data> 'e' 'r.txt' using 1:'$2*k';\n"
                                                        "@ImposedStrain<function> 'EXX' 'e';\n"
                                                        "@Test<file> 'r.txt' {'SXX' : 3, 'SYY' : '$3/$2 + k'} 1;\n");
  const MtestFile file = read_mtest(name);
  EXPECT_EQ(file.times, (std::vector<double>{0, 1, 2}));
  EXPECT_EQ(file.imposed[0].value(1.5), 30);
  ASSERT_EQ(file.comparisons.size(), 2u);
  EXPECT_EQ(file.comparisons[0].file, scratch / "r.txt");
  EXPECT_EQ(expected_lines(file, file.comparisons[0]), (std::vector<double>{0, 30, 50}));
  EXPECT_EQ(expected_lines(file, file.comparisons[1])[2], 22.5);
}

TEST(MtestFile, AFileOfValuesThatIsDamagedIsNamedByLine) {
  const ScratchFolder scratch;
  scratch.write("r.txt", "0 1\n1 x\n2\n");
  const MtestFile file =
      mtest_from_text(behaviour + times + "@Test<file> 'r.txt' {'EXX' : 2} 1;\n@Test<file> 'r.txt' {'EYY' : 1} 1;\n",
                      scratch / "a.mtest");
  const auto lines = [&](std::size_t i) { return refusal_of([&] { expected_lines(file, file.comparisons[i]); }); };
  EXPECT_EQ(lines(0), (scratch / "r.txt") + ":2:3: 'x' is no number");
  EXPECT_EQ(lines(1), "accepted");
}

TEST(MtestFile, ValuesOfLibrariesAreLeftToTheCaller) {
  const MtestFile file = read("@MaterialProperty<castem> 'E' 'mp.so' 'Young';\n");
  ASSERT_TRUE(file.properties[0].computed_by.has_value());
  EXPECT_EQ(file.properties[0].computed_by->function, "Young");
  EXPECT_FALSE(file.properties[0].value);
  EXPECT_EQ(refused("@MaterialProperty<castem> 'E' 'mp.so' 'Young';\n@Evolution<function> 'a' '2*E';\n"),
            "a.mtest:4:27: 'E' is computed by a library, and a formula cannot hold it");
}

TEST(MtestFile, ParametersOfTheBehaviourComeFromOutside) {
  const std::string text = behaviour + times + "@Real 'a' '2*Law::k';\n";
  EXPECT_EQ(mtest_from_text(text, "a.mtest", {{}, {{"Law::k", 21}}}).evolutions.at("a")(0), 42);
  EXPECT_EQ(refused("@Real 'a' '2*Law::k';\n"), "a.mtest:3:12: @Real: unknown name in a formula");
}

}  // namespace
}  // namespace assay::drivers::test_mtest_file
