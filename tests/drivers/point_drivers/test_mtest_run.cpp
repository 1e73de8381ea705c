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
  EXPECT_TRUE(
      has(refused(base + "@ExternalStateVariable 'Temperature' {0.:293.,1.:400.};\n"), "changes along the path"));
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

}  // namespace
}  // namespace assay::drivers::test_mtest_run
