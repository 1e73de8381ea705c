// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/specimen.hpp"

#include <gtest/gtest.h>

#include "tests/harness/check/model_table.hpp"

namespace assay::check::test_specimen {
namespace {

using check_tests::read;
using check_tests::write;

/// Saint-Venant and Kirchhoff's elasticity that does not stand everything.
struct Fragile {
  double E, breaks_at, refuses_at, needs_strain, yields_at;
};

double green_strain(const Tensor& F) { return (0.5 * (F.transpose() * F - Tensor::Identity())).cwiseAbs().maxCoeff(); }

void update_fragile(void* self, const assay_step* step, std::size_t n, const double* state0, double* state1,
                    double* cauchy, std::int32_t* status, double*, char* message) {
  const Fragile& m = *static_cast<const Fragile*>(self);
  for (std::size_t p = 0; p < n; ++p) {
    const Tensor F = read(step->F1, n, p), strain = 0.5 * (F.transpose() * F - Tensor::Identity());
    const double size = green_strain(F), largest = state1[p] = std::max(state0[p], size);
    const double left = largest > m.breaks_at ? 0 : 1, yield = size > m.yields_at ? m.yields_at / size : 1;
    const Tensor S = left * yield * m.E * (strain + 0.5 * strain.trace() * Tensor::Identity());
    // As laws divide by the strain that there is.
    const double there = m.needs_strain > 0 ? size / size : 1;
    write(there * F * S * F.transpose() / F.determinant(), cauchy, n, p);
    status[p] = size > m.refuses_at ? ASSAY_FAILED : ASSAY_GOOD;
    if (size > m.refuses_at) std::strcpy(message, "too much");
  }
}

Material fragile(const std::map<std::string, double>& knobs) {
  static const assay_parameter parameters[] = {{"E", "Pa", 1e3, 0, 1e12, ""},
                                               {"breaks_at", "1", 1e9, 0, 1e9, ""},
                                               {"refuses_at", "1", 1e9, 0, 1e9, ""},
                                               {"needs_strain", "1", 0, 0, 1, ""},
                                               {"yields_at", "1", 1e9, 0, 1e9, ""}};
  static const assay_state_variable state[] = {{"largest", "1", ASSAY_SCALAR, ASSAY_ROLE_PLAIN, ""}};
  static const assay_material table = [] {
    assay_material t{};
    t.abi_major = ASSAY_ABI_MAJOR, t.struct_size = sizeof t;
    t.name = "fragile", t.version = "1", t.licence = "BSD-3-Clause", t.doc = "";
    t.symmetry = ASSAY_ISOTROPIC, t.flags = ASSAY_THREAD_SAFE;
    t.parameter_count = 5, t.parameters = parameters, t.state_count = 1, t.state = state;
    t.create = [](const double* p, char*) -> void* { return new Fragile{p[0], p[1], p[2], p[3], p[4]}; };
    t.destroy = [](void* self) { delete static_cast<Fragile*>(self); };
    t.initial_state = [](void*, std::size_t n, const double* cauchy, double* state0) -> std::int32_t {
      std::fill_n(state0, n, 0.0);
      return std::all_of(cauchy, cauchy + 9 * n, [](double c) { return c == 0; }) ? ASSAY_GOOD : ASSAY_FAILED;
    };
    t.update = update_fragile;
    return t;
  }();
  return Material(&table, knobs);
}

TEST(Specimen, TakesTheUsualStrainsWhereNothingForbidsThem) {
  const Specimen specimen = examine(fragile({}), {});
  EXPECT_EQ(specimen.amplitude, Effort{}.strain);
  EXPECT_EQ(specimen.pressure, 0);
  EXPECT_EQ(examine(fragile({}), {.effort = {.strain = 0.02}}).amplitude, 0.02);
}

TEST(Specimen, SaysTheSameLimitWhateverStrainIsAskedFor) {
  const Material material = fragile({{"refuses_at", 0.01}});
  const double usual = examine(material, {}).amplitude;
  EXPECT_LT(usual, 0.01);
  for (const double strain : {0.02, 0.05, 0.3}) {
    EXPECT_EQ(examine(material, {.effort = {.strain = strain, .strain_is_asked = true}}).amplitude, usual) << strain;
  }
}

TEST(Specimen, KeepsBelowWhatBreaks) {
  const Material material = fragile({{"breaks_at", 1e-3}});
  const Specimen specimen = examine(material, {});
  EXPECT_GT(specimen.amplitude, 1e-4);
  EXPECT_LT(specimen.amplitude, 0.1);
  const March way = march(material, out_and_back(specimen), {.steps = 40, .state = specimen.rest_state()});
  EXPECT_GT(way.largest, 0.04 * specimen.modulus * specimen.amplitude);
}

/// What is broken where histories end would agree with anything.
TEST(Specimen, CarriesAStressWhereHistoriesEnd) {
  const Material material = fragile({{"breaks_at", 0.13}});
  const Specimen specimen = examine(material, {});
  EXPECT_LT(specimen.amplitude, Effort{}.strain);
  const March way = march(material, out_and_back(specimen), {.steps = 40, .state = specimen.rest_state()});
  for (const Point& mark : way.marks) {
    EXPECT_GT(mark.cauchy.cwiseAbs().maxCoeff(), 0.04 * specimen.modulus * specimen.amplitude);
  }
}

TEST(Specimen, KeepsToSomeTimesTheElasticRange) {
  const Specimen specimen = examine(fragile({{"yields_at", 1e-3}}), {});
  EXPECT_NEAR(specimen.onset, 1e-3, 1e-3);
  EXPECT_GE(specimen.amplitude, 0.01);
  EXPECT_LT(specimen.amplitude, 0.1);
}

TEST(Specimen, ABatteryThatIsRefusedBeginsAgainAtSmallerStrains) {
  constexpr double beyond = 0.06;  // some tests go further than the loading by which the strain is chosen
  const Report report = run_battery(fragile({{"refuses_at", beyond}}), {.effort = {.quick = true}});
  EXPECT_TRUE(report.passes()) << report.diagnosis.front().sentence;
  EXPECT_LT(report.strain, beyond);
  const Report never = run_battery(fragile({{"refuses_at", 0}}), {.effort = {.quick = true}});
  ASSERT_FALSE(never.passes());
  EXPECT_EQ(never.diagnosis.front().cause, causes::refuses);
}

TEST(Specimen, AStepWithoutDeformationIsNoQuestionOfStretches) {
  const Report report = run_battery(fragile({{"needs_strain", 1}}), {.effort = {.quick = true}});
  ASSERT_FALSE(report.passes());
  EXPECT_EQ(report.diagnosis.front().cause, causes::not_finite);
}

}  // namespace
}  // namespace assay::check::test_specimen
