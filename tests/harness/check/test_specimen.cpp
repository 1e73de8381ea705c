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

/// An initial stress that is converted from some measure to Cauchy's, and moduli in units of it, as of soils.
struct Converted {
  static constexpr std::size_t state_size = 6;
  enum Measure : int { cauchy, kirchhoff, first, second, covariant, inverse, measures };

  explicit Converted(const double* p) : measure(static_cast<int>(p[0])), bulk(p[1]), shear(p[2]) {}

  std::optional<Tensor> take(const check_tests::PointStep& step, const double* state0, double* state1) const {
    const Tensor S = check_tests::read_symmetric(state0), F = step.F1;
    const Tensor strain = 0.5 * (F + F.transpose()) - Tensor::Identity();
    const double p = -S.trace() / 3;
    std::copy_n(state0, 6, state1);
    return converted(S, F) + p * (bulk * check_tests::sphere(strain) * 3 + 2 * shear * check_tests::deviator(strain));
  }
  Tensor converted(const Tensor& S, const Tensor& F) const {
    const double J = F.determinant();
    switch (measure) {
      case kirchhoff:
        return S / J;
      case first:
        return (S * F.transpose() + F * S) / (2 * J);
      case second:
        return F * S * F.transpose() / J;
      case covariant:
        return F.transpose().inverse() * S * F.inverse();
      case inverse:
        return J * F.inverse() * S * F.transpose().inverse();
    }
    return S;
  }
  static bool rest(const Tensor& stress, double* state) {
    check_tests::write_symmetric(stress, state);
    return true;
  }
  static void misbehave(std::size_t, double*, double*) {}

  int measure;
  double bulk, shear;
};

Material converted(int measure, double bulk, double shear) {
  static const assay_parameter parameters[] = {
      {"measure", "1", 0, 0, 9, ""}, {"bulk", "1", 0, 0, 1e3, ""}, {"shear", "1", 0, 0, 1e3, ""}};
  static const assay_state_variable state[] = {{"stress", "Pa", ASSAY_SYMMETRIC_TENSOR, ASSAY_ROLE_ROTATES_ITSELF, ""}};
  static const assay_material table =
      check_tests::table_of<Converted>("converted", ASSAY_THREAD_SAFE | ASSAY_USES_INCREMENT, parameters, state);
  return Material(&table, {{"measure", double(measure)}, {"bulk", bulk}, {"shear", shear}});
}

TEST(Specimen, APressureThatIsOnlyCarriedAlongIsNoStiffness) {
  for (int measure = 0; measure < Converted::measures; ++measure) {
    EXPECT_EQ(pressure_at_rest(converted(measure, 0, 0)), 0) << measure;
    EXPECT_EQ(pressure_at_rest(converted(measure, 20, 10)), 1e5) << measure << ": a soft clay";
    EXPECT_EQ(pressure_at_rest(converted(measure, 0, 5)), 1e5) << measure << ": a shear stiffness alone";
  }
  EXPECT_EQ(pressure_at_rest(converted(Converted::cauchy, 1.4, 0)), 1e5) << "a gas";
  const Report report = run_battery(converted(Converted::kirchhoff, 0, 0), {.effort = {.quick = true}});
  ASSERT_FALSE(report.passes());
  EXPECT_EQ(report.diagnosis.front().cause, causes::no_stress) << report.diagnosis.front().sentence;
}

/// By whatever function a model says it.
TEST(Specimen, AnOverrunAtTheBeginningIsNamedAsOne) {
  static const assay_reason reason{sizeof(assay_reason),
                                   [](void*) { return "overrun: initial_state writes past the state"; }};
  static const assay_state_variable state[] = {{"own", "1", ASSAY_SCALAR, ASSAY_ROLE_PLAIN, ""}};
  static const assay_material table = [] {
    assay_material t = check_tests::named_table("overruns", 0, {}, state);
    t.create = [](const double*, char*) -> void* { return new int; };
    t.destroy = [](void* self) { delete static_cast<int*>(self); };
    t.update = update_fragile;
    t.initial_state = [](void*, std::size_t, const double*, double*) -> std::int32_t { return ASSAY_FAILED; };
    t.extension = [](const char* id) -> const void* {
      return std::string(id) == ASSAY_EXTENSION_REASON ? &reason : nullptr;
    };
    return t;
  }();
  const Report report = run_battery(Material(&table, {}), {.effort = {.quick = true}});
  ASSERT_FALSE(report.passes());
  EXPECT_EQ(report.diagnosis.front().cause, causes::overrun) << report.diagnosis.front().sentence;
}

TEST(Specimen, AStepWithoutDeformationIsNoQuestionOfStretches) {
  const Report report = run_battery(fragile({{"needs_strain", 1}}), {.effort = {.quick = true}});
  ASSERT_FALSE(report.passes());
  EXPECT_EQ(report.diagnosis.front().cause, causes::not_finite);
}

}  // namespace
}  // namespace assay::check::test_specimen
