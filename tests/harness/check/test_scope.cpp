// SPDX-License-Identifier: BSD-3-Clause
// What the battery has not tested is said, and what was asked for and is not reached is a failure.
#include "harness/check/tests.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "tests/harness/builtin_material.hpp"
#include "tests/harness/check/model_table.hpp"
#include "tests/harness/elastic_material.hpp"

namespace assay::check::test_scope {
namespace {

/// An elastic law that refuses whatever is beyond its limits; a parameter says which.
struct Model {
  double mu, lambda, largest_strain, longest_step, largest_increment;
};

void update(void* self, const assay_step* step, std::size_t n, const double*, double*, double* cauchy,
            std::int32_t* status, double*, char* message) {
  const auto& m = *static_cast<const Model*>(self);
  for (std::size_t p = 0; p < n; ++p) {
    const Tensor F = check_tests::read(step->F1, n, p), b = F * F.transpose();
    const double J = F.determinant();
    const Tensor sigma = (m.lambda * std::log(J) * Tensor::Identity() + m.mu * (b - Tensor::Identity())) / J;
    check_tests::write(sigma, cauchy, n, p);
    const bool far = (b - Tensor::Identity()).norm() > 2 * m.largest_strain;
    const Tensor F0 = check_tests::read(step->F0, n, p);
    const bool large = (F.transpose() * F - F0.transpose() * F0).norm() > 2 * m.largest_increment;
    status[p] = far || large || step->dt > m.longest_step ? ASSAY_FAILED : ASSAY_GOOD;
    if (status[p] == ASSAY_FAILED) std::strcpy(message, far ? "too far" : large ? "too much" : "too long");
  }
}

const assay_material* table(std::uint32_t flags) {
  static const assay_parameter parameters[] = {{"mu", "Pa", 400, 0, 1e12, "shear modulus"},
                                               {"lambda", "Pa", 600, 0, 1e12, "Lame's first"},
                                               {"strain", "1", 1e3, 0, 1e12, "the largest that it takes"},
                                               {"step", "s", 1e30, 0, 1e31, "the longest that it takes"},
                                               {"increment", "1", 1e3, 0, 1e12, "the largest that it takes"}};
  static assay_material made[2];
  assay_material& t = made[flags == 0 ? 0 : 1];
  t = check_tests::named_table("limited_for_tests", flags, parameters, {});
  t.create = [](const double* p, char*) -> void* { return new Model{p[0], p[1], p[2], p[3], p[4]}; };
  t.destroy = [](void* self) { delete static_cast<Model*>(self); };
  t.update = update;
  return &t;
}

Material limited(const std::map<std::string, double>& parameters, std::uint32_t flags = 0) {
  return Material(table(flags), parameters);
}

bool says(const Report& report, const std::string& words) {
  return std::any_of(report.not_tested.begin(), report.not_tested.end(),
                     [&](const std::string& what) { return what.find(words) != std::string::npos; });
}

TEST(Scope, ModuliThatNothingIsComparedWithAreNotTested) {
  const Report report = run_battery(limited({{"mu", 800}}), {.effort = {.quick = true}});
  EXPECT_TRUE(report.passes());
  EXPECT_TRUE(says(report, "the values of the parameters"));
  EXPECT_FALSE(says(report, "strains above"));
}

TEST(Scope, ReferencesAreNoGap) {
  const Report report = run_battery(*elastic_material(), {.effort = {.quick = true}});
  EXPECT_FALSE(says(report, "the values of the parameters"));  // its closed form is compared
}

TEST(Scope, StrainsThatAreNotReachedAreSaid) {
  const Report report = run_battery(limited({{"strain", 1e-3}}), {.effort = {.quick = true}});
  EXPECT_TRUE(report.passes());
  EXPECT_LT(report.strain, 1e-3);
  EXPECT_TRUE(says(report, "strains above"));
}

/// A limit on increments is none on strains, whether a kink is declared or not.
TEST(Scope, IncrementsThatAreRefusedAreToldFromStrains) {
  constexpr std::uint32_t reads_F0 = ASSAY_USES_INCREMENT;
  for (const std::uint32_t flags : {reads_F0, reads_F0 | ASSAY_NON_SMOOTH}) {
    const Report report = run_battery(limited({{"increment", 1e-3}}, flags), {.effort = {.quick = true}});
    EXPECT_TRUE(report.passes()) << flags << (report.passes() ? "" : report.diagnosis.front().sentence);
    EXPECT_TRUE(says(report, "it takes them only in shorter increments")) << flags;
    EXPECT_FALSE(says(report, "it refuses them")) << flags;
  }
}

TEST(Scope, StrainsThatWereAskedForAndAreNotReachedFail) {
  for (const double strain : {0.05, 0.01}) {
    const Report report = run_battery(limited({{"strain", 1e-3}}),
                                      {.effort = {.quick = true, .strain = strain, .strain_is_asked = true}});
    ASSERT_FALSE(report.passes()) << strain;
    EXPECT_EQ(report.diagnosis.front().cause, causes::not_reached);
    EXPECT_NE(report.diagnosis.front().sentence.find("too far"), std::string::npos);
  }
  const Report reached = run_battery(limited({}), {.effort = {.quick = true, .strain = 0.05, .strain_is_asked = true}});
  EXPECT_TRUE(reached.passes());
  EXPECT_EQ(reached.strain, 0.05);
}

/// A model that refuses what leaves its straight line is never tested where it matters.
TEST(Scope, AKinkThatIsDeclaredAndRefusedFails) {
  const Report report = run_battery(limited({{"strain", 1e-3}}, ASSAY_NON_SMOOTH), {.effort = {.quick = true}});
  ASSERT_FALSE(report.passes());
  EXPECT_EQ(report.diagnosis.front().cause, causes::refuses);
  EXPECT_NE(report.diagnosis.front().sentence.find("non_smooth"), std::string::npos);
}

TEST(Scope, AKinkThatIsDeclaredAndNotMetIsSaid) {
  const auto material = builtin_material(assay_builtin_j2_jaumann,
                                         {{"E", 1e3}, {"nu", 0.3}, {"yield_stress", 1e6}, {"hardening_modulus", 0}});
  const Report report = run_battery(*material, {.effort = {.quick = true, .strain = 0.01, .strain_is_asked = true}});
  EXPECT_TRUE(report.passes());
  EXPECT_TRUE(
      says(report, "a threshold such as first yield (a kink is declared, and the stress grows almost linearly"));
}

/// The length of a step that is refused is told from its strain: shorter ones are taken, and all is judged in them.
TEST(Scope, StepsAreAsShortAsTheModelAsks) {
  for (const double longest : {0.75, 1e-5}) {
    const Report report = run_battery(limited({{"step", longest}}), {.effort = {.quick = true}});
    EXPECT_TRUE(report.passes()) << longest << " " << (report.passes() ? "" : report.diagnosis.front().sentence);
    EXPECT_LE(report.effort.step, longest);
    EXPECT_GE(report.effort.step, 0.05 * longest);
    EXPECT_TRUE(says(report, "steps above"));
    EXPECT_EQ(report.strain, Effort{}.strain);
  }
}

TEST(Scope, StepsThatWereAskedForAndAreRefusedFailByTheirLength) {
  const Report report = run_battery(limited({{"step", 1e-5}}), {.effort = {.quick = true, .step = 1e-3}});
  ASSERT_FALSE(report.passes());
  EXPECT_EQ(report.diagnosis.front().cause, causes::refuses_length);
}

}  // namespace
}  // namespace assay::check::test_scope
