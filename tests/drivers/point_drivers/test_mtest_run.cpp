// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/point_drivers/mtest_run.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "drivers/point_drivers/niemunis_run.hpp"
#include "tests/drivers/refusal.hpp"
#include "tests/drivers/scratch_folder.hpp"
#include "tests/support/built.hpp"

namespace assay::drivers::test_mtest_run {
namespace {

MtestOptions options_for(const std::string& file, const std::string& out, const std::string& material = {}) {
  MtestOptions options;
  options.scene = file, options.out = out, options.material = material;
  options.verbosity = Verbosity::quiet;
  return options;
}

/// Status of a file of MTest with these lines, run with a material.
int status_of(const std::string& lines, const std::string& material) {
  const ScratchFolder scratch;
  const std::string text = "@Behaviour<generic> 'none' 'none';\n" + lines;
  return tabulate_mtest(options_for(scratch.write("test.mtest", text), scratch / "out", material));
}

std::string refused(const std::string& lines, const std::string& material = "neo_hookean") {
  return refusal_of([&] { status_of(lines, material); });
}

/// Small strain of an elastic law: with a tiny strain its stress is Hooke's.
TEST(MtestRun, ComparesWithFormulas) {
  const std::string elastic =
      "@MaterialProperty<constant> 'YoungModulus' 1000.;\n@MaterialProperty<constant> 'PoissonRatio' 0.3;\n"
      "@ExternalStateVariable 'Temperature' 293.15;\n@ImposedStrain 'EXX' {0.:0.,1.:1.e-6};\n@Times {0.,1. in 5};\n";
  EXPECT_EQ(status_of(elastic + "@Test<function> 'SXX' '1000*1.e-6*t' 1.e-8;\n"
                                "@Test<function> {'EYY':'-0.3e-6*t','EZZ':'-0.3e-6*t'} 1.e-11;\n"
                                "@Test<function> 'SXY' '0.' 1.e-10;\n",
                      "neo_hookean"),
            0);
  EXPECT_EQ(status_of(elastic + "@Test<function> 'SXX' '1001*1.e-6*t' 1.e-8;\n", "neo_hookean"), 1);
}

/// A shear strain of MTest is sqrt 2 times that of the tensor, and so is its stress: S = 2 mu E.
TEST(MtestRun, ShearsCarryTheRootOfTwo) {
  EXPECT_EQ(
      status_of("@MaterialProperty<constant> 'YoungModulus' 1000.;\n@MaterialProperty<constant> 'PoissonRatio' 0.25;\n"
                "@ImposedStrain 'EXY' {0.:0.,1.:1.e-6};\n@Times {0.,1.};\n"
                "@Test<function> 'SXY' '800.e-6' 1.e-9;\n",
                "neo_hookean"),
      0);
}

/// Creep under an imposed stress, on a ring's hypothesis: the model's own increments. In the first one it takes the
/// stress for growing straight from zero.
TEST(MtestRun, CreepOnAnAxisymmetricHypothesis) {
  const std::string creep =
      "@ModellingHypothesis 'AxisymmetricalGeneralisedPlaneStrain';\n"
      "@MaterialProperty<constant> 'YoungModulus' 1000.;\n@MaterialProperty<constant> 'PoissonRatio' 0.3;\n"
      "@MaterialProperty<constant> 'reference_rate' 0.001;\n@MaterialProperty<constant> 'reference_stress' 1.;\n"
      "@MaterialProperty<constant> 'exponent' 2.;\n@ImposedStress 'SZZ' 2.;\n@Times {0.,1. in 20};\n"
      "@Test<function> 'EZZ' '2./1000+0.004*t' 1.4e-4;\n@Test<function> 'p' '0.004*t' 1.4e-4;\n"
      "@Test<function> 'ERR' '-0.3*0.002-0.002*t' 1.4e-4;\n";
  EXPECT_EQ(status_of(creep, "norton"), 0);
}

/// Finite strain, and a file of references: F in tension with free faces.
TEST(MtestRun, FiniteStrainAgainstAFile) {
  const ScratchFolder scratch;
  const double mu = 1000 / 2.6, lambda = 300 / 1.3 / 0.4;
  std::string reference = "# time FXX FYY\n";
  for (int k = 0; k <= 4; ++k) {
    const double longer = 1 + 0.1 * k;
    double narrow = 1;
    for (int i = 0; i < 100; ++i) {
      const double f = lambda * std::log(longer * narrow * narrow) + mu * (narrow * narrow - 1);
      narrow -= f / (2 * lambda / narrow + 2 * mu * narrow);
    }
    char line[100];
    std::snprintf(line, sizeof line, "%.17g %.17g %.17g\n", 0.25 * k, longer, narrow);
    reference += line;
  }
  scratch.write("reference.txt", reference);
  const std::string text =
      "@Behaviour<generic> '@library@' 'none';\n@MaterialProperty<constant> 'YoungModulus' 1000.;\n"
      "@MaterialProperty<constant> 'PoissonRatio' 0.3;\n@ImposedDeformationGradient 'FXX' {0.:1.,1.:1.4};\n"
      "@ImposedDeformationGradient 'FXY' 0.;\n@ImposedDeformationGradient 'FYX' 0.;\n"
      "@ImposedDeformationGradient 'FXZ' 0.;\n@ImposedDeformationGradient 'FZX' 0.;\n"
      "@ImposedDeformationGradient 'FYZ' 0.;\n@ImposedDeformationGradient 'FZY' 0.;\n@Times {0.,1. in 4};\n"
      "@Test<file> 'reference.txt' {'FXX':2,'FYY':3} 1.e-9;\n";
  MtestOptions options = options_for(scratch.write("test.mtest", text), scratch / "out", "neo_hookean");
  options.placeholders = {{"library", "unused"}};
  EXPECT_EQ(tabulate_mtest(options), 0);
  EXPECT_TRUE(
      bytes_of(options.out + "/comparisons.csv").starts_with("variable,largest_difference,t,tolerance,holds\nFXX,"));
}

TEST(MtestRun, SaysWhatItCannotDo) {
  const std::string base =
      "@MaterialProperty<constant> 'YoungModulus' 1.;\n@Times {0.,1.};\n@ImposedStrain 'EXX' 0.;\n";
  const auto has = [](const std::string& text, const char* word) { return text.find(word) != text.npos; };
  EXPECT_TRUE(has(refused("@MaterialProperty<function> 'E' '1+t';\n" + base), "changes with time"));
  EXPECT_TRUE(has(refused(base + "@MaterialProperty<constant> 'Other' 1.;\n"), "Other"));
  EXPECT_TRUE(has(refusal_of([] { placeholders_of({"library"}); }), "NAME=VALUE"));
}

/// A behaviour of MFront's generic interface, by its library.
TEST(MtestRun, TakesABehaviourByItsLibrary) {
  const std::string library = built("tests/foreign/mfront_norton.so");
  const ScratchFolder scratch;
  const std::string text =
      "@Behaviour<generic> @library@ 'Norton';\n@Parameter 'A' 1.e-3;\n@Parameter 'n' 2.;\n"
      "@MaterialProperty<constant> 'YoungModulus' 1000.;\n@MaterialProperty<constant> 'PoissonRatio' 0.3;\n"
      "@ExternalStateVariable 'Temperature' 293.15;\n@ImposedStress 'SXX' 2.;\n@Times {0.,1. in 10};\n"
      "@Test<function> 'EXX' '2./1000+0.004*t' 1.e-8;\n"
      "@Test<function> 'EquivalentViscoplasticStrain' '0.004*t' 1.e-8;\n"
      "@Test<function> 'ElasticStrainXX' '0.002' 1.e-8;\n";
  MtestOptions options = options_for(scratch.write("test.mtest", text), scratch / "out");
  options.placeholders = {{"library", "'" + library + "'"}};
  EXPECT_EQ(tabulate_mtest(options), 0);
}

/// Drained triaxial compression from a confining stress, by the incremental driver's own words.
TEST(NiemunisRun, TriaxialCompression) {
  const ScratchFolder scratch;
  scratch.write("parameters.inp", "soil\n6\n1000.\n0.3\n15.\n0.2\n0.1\n0.\n");
  scratch.write("initialconditions.inp", "6\n-20.\n-20.\n-20.\n0.\n0.\n0.\n0\n");
  SceneOptions options;
  options.scene = scratch.write("test.inp", "out.txt\n*TriaxialE1\n20 10 1.\n-0.2\n");
  options.out = scratch / "out", options.verbosity = Verbosity::quiet;
  ASSERT_EQ(tabulate_niemunis(options, "drucker_prager"), 0);
  const std::string csv = bytes_of(options.out + "/path.csv");
  const double q = (15 + 3 * 0.2 * 20) / (1 / std::sqrt(3.0) - 0.2);  // at its peak, of Cauchy stresses over J ~ 1
  EXPECT_NE(csv.find("\n1,"), csv.npos);
  EXPECT_GT(q, 0);
  EXPECT_NE(refusal_of([&] { tabulate_niemunis(options, ""); }).find("--material"), std::string::npos);
}

/// A behaviour that expands: a free point strains by alpha (T - T(0)), one that is held is compressed.
TEST(MtestRun, ATemperatureChangesAlongThePath) {
  const ScratchFolder scratch;
  const std::string behaviour = "@Behaviour<generic> '" + built("tests/foreign/") + "mfront_thermal.so' 'Thermal';\n" +
                                "@MaterialProperty<constant> 'YoungModulus' 1000.;\n"
                                "@MaterialProperty<constant> 'PoissonRatio' 0.3;\n"
                                "@MaterialProperty<constant> 'Expansion' 1.e-4;\n"
                                "@ExternalStateVariable 'Temperature' {0.:300.,1.:400.,2.:350.};\n"
                                "@ExternalStateVariable<function> 'Swelling' '1.e-3*t*t';\n"
                                "@ExternalStateVariable 'Unused' {0.:1.,1.:2.};\n@Times {0.,2. in 4};\n"
                                "@Real 'a' 1.e-4;\n";
  const auto status = [&](const std::string& lines) {
    return tabulate_mtest(options_for(scratch.write("test.mtest", behaviour + lines), scratch / "out"));
  };
  EXPECT_EQ(status("@ImposedStress 'SXX' 0.;\n@Test<function> 'EXX' 'a*(Temperature-300)+1.e-3*t*t' 1.e-13;\n"
                   "@Test<function> {'warm':'Temperature','swollen':'Swelling'} 1.e-12;\n"),
            0);
  EXPECT_EQ(status("@ImposedStrain 'EXX' 0.;\n@ImposedStrain 'EYY' 0.;\n@ImposedStrain 'EZZ' 0.;\n"
                   "@Test<function> 'SYY' '-2500*(a*(Temperature-300)+1.e-3*t*t)' 1.e-9;\n"),
            0);
  EXPECT_EQ(status("@ImposedStress 'SXX' 0.;\n@Test<function> 'EXX' 'a*(Temperature-300)' 1.e-6;\n"), 1);
}

/// MTest itself takes the strain of the property ThermalExpansion off what a behaviour of small strain is given.
TEST(MtestRun, AThermalStrainIsTakenOff) {
  const std::string expands =
      "@MaterialProperty<constant> 'ThermalExpansion' 1.e-7;\n@MaterialProperty<constant> 'YoungModulus' 1000.;\n"
      "@MaterialProperty<constant> 'PoissonRatio' 0.3;\n@ExternalStateVariable 'Temperature' {0.:293.15,1.:393.15};\n"
      "@Times {0.,1. in 2};\n";
  EXPECT_EQ(status_of(expands + "@ImposedStress 'SXX' 0.;\n@Test<function> {'EXX':'1.e-5*t'} 1.e-13;\n", "neo_hookean"),
            0);
  EXPECT_EQ(status_of(expands + "@ImposedStrain 'EXX' 0.;\n@ImposedStrain 'EYY' 0.;\n@ImposedStrain 'EZZ' 0.;\n"
                                "@Test<function> {'SXX':'-2500*1.e-5*t','EXX':'0'} 1.e-6;\n",
                      "neo_hookean"),
            0);
  const std::string cold = "@MaterialProperty<constant> 'ThermalExpansionReferenceTemperature' 393.15;\n";
  EXPECT_EQ(status_of(expands + cold + "@ImposedStress 'SXX' 0.;\n@Test<function> {'EXX':'1.e-5*(t-1)'} 1.e-13;\n",
                      "neo_hookean"),
            0);
}

/// As MTest, whose map takes no name twice.
TEST(MtestRun, OfAVariableThatStandsTwiceTheFirstCounts) {
  const std::string elastic =
      "@MaterialProperty<constant> 'YoungModulus' 1000.;\n@MaterialProperty<constant> 'PoissonRatio' 0.3;\n"
      "@ImposedStrain 'EXX' {0.:0.,1.:1.e-6};\n@Times {0.,1.};\n";
  EXPECT_EQ(status_of(elastic + "@Test<function> {'SXX':'1.e-3','SXX':'7.'} 1.e-8;\n", "neo_hookean"), 0);
  EXPECT_EQ(status_of(elastic + "@Test<function> {'SXX':'7.','SXX':'1.e-3'} 1.e-8;\n", "neo_hookean"), 1);
}

TEST(MtestRun, PlaneStressLeavesTheStrainAcrossAlone) {
  EXPECT_EQ(status_of("@ModellingHypothesis 'PlaneStress';\n@MaterialProperty<constant> 'YoungModulus' 1000.;\n"
                      "@MaterialProperty<constant> 'PoissonRatio' 0.3;\n@ImposedStrain 'EXX' {0.:0.,1.:1.e-6};\n"
                      "@Times {0.,1.};\n@Test<function> {'SXX':'1.e-3*t','EZZ':'0','AxialStrain':'-0.3e-6*t'} 1.e-8;\n",
                      "neo_hookean"),
            0);
}

/// A point that begins strained and loaded: what its elastic strain says of it counts.
TEST(MtestRun, BeginsStrainedAndLoaded) {
  const ScratchFolder scratch;
  const std::string text =
      "@Behaviour<generic> '" + built("tests/foreign/") +
      "mfront_norton.so' 'Norton';\n@MaterialProperty<constant> 'YoungModulus' 1000.;\n"
      "@MaterialProperty<constant> 'PoissonRatio' 0.3;\n@Parameter 'A' 1.e-3;\n@Parameter 'n' 2.;\n"
      "@ExternalStateVariable 'Temperature' 293.15;\n@ImposedStress 'SXX' 1.;\n@Strain "
      "{1.e-3,-3.e-4,-3.e-4,0.,0.,0.};\n"
      "@InternalStateVariable 'ElasticStrain' {1.e-3,-3.e-4,-3.e-4,0.,0.,0.};\n@Stress {1.,0.,0.,0.,0.,0.};\n"
      "@Times {0.,1. in 4};\n@Test<function> {'EXX':'1.e-3+1.e-3*t','EYY':'-3.e-4-0.5e-3*t'} 1.e-9;\n";
  EXPECT_EQ(tabulate_mtest(options_for(scratch.write("test.mtest", text), scratch / "out")), 0);
}

/// Under its own hypothesis, where it has one, with a property that changes.
TEST(MtestRun, APropertyChangesInThePlane) {
  const ScratchFolder scratch;
  const std::string text = "@ModellingHypothesis 'PlaneStrain';\n@Behaviour<generic> '" + built("tests/foreign/") +
                           "mfront_norton.so' 'Norton';\n@MaterialProperty<function> 'YoungModulus' '1000*(1+t)';\n"
                           "@MaterialProperty<constant> 'PoissonRatio' 0.25;\n@Parameter 'A' 0.;\n@Parameter 'n' 2.;\n"
                           "@ExternalStateVariable 'Temperature' 293.15;\n@ImposedStrain 'EXY' {0.:0.,1.:1.e-4};\n"
                           "@Times {0.,1. in 4};\n@Test<function> {'SXY':'800*(1+t)*1.e-4*t','EZZ':'0'} 1.e-9;\n";
  EXPECT_EQ(tabulate_mtest(options_for(scratch.write("test.mtest", text), scratch / "out")), 0);
}

/// The material's directions are the columns of the matrix: a turn by 90 degrees about z changes E_r and E_t.
TEST(MtestRun, ARotationTurnsTheMaterial) {
  const auto status = [](const std::string& rotation, double modulus, double shear) {
    std::string lines = rotation;
    const std::pair<const char*, double> constants[] = {{"E_r", 1000},  {"E_t", 1500},   {"E_z", 700},
                                                        {"nu_rt", 0.2}, {"nu_rz", 0.25}, {"nu_tz", 0.3},
                                                        {"G_rt", 350},  {"G_rz", 300},   {"G_tz", 400}};
    for (const auto& [name, value] : constants)
      lines += "@MaterialProperty<constant> '" + std::string(name) + "' " + std::to_string(value) + ";\n";
    return status_of(lines +
                         "@ImposedStrain 'EXX' {0.:0.,1.:1.e-7};\n@ImposedStrain 'EXZ' {0.:0.,1.:1.e-7};\n"
                         "@Times {0.,1.};\n@Test<function> {'SXX':'" +
                         std::to_string(modulus) + "*1.e-7','SXZ':'" + std::to_string(2 * shear) + "*1.e-7'} 1.e-9;\n",
                     "orthotropic_cylindrical");
  };
  EXPECT_EQ(status("", 1000, 300), 0);
  EXPECT_EQ(status("@RotationMatrix {{0,-1,0},{1,0,0},{0,0,1}};\n", 1500, 400), 0);
  EXPECT_EQ(status("@RotationMatrix<Euler> {1.5707963267948966,0.,0.};\n", 1500, 400), 0);
  EXPECT_EQ(status("@RotationMatrix {{0,-1,0},{1,0,0},{0,0,1}};\n", 1000, 300), 1);
}

}  // namespace
}  // namespace assay::drivers::test_mtest_run
