// SPDX-License-Identifier: BSD-3-Clause
// Sheets and histories of materials that are not as well-behaved as they say.
#include <gtest/gtest.h>

#include "harness/history/history.hpp"
#include "harness/motion/kinds/vortex.hpp"
#include "tests/harness/disturbed_material.hpp"
#include "tests/harness/elastic_material.hpp"
#include "tests/harness/sheet_difference.hpp"

namespace assay::test_sheet_disturbed {
namespace {

const Path path = Vortex{0.75, 1.25, 2, {Amplitude::Type::sine, 0.1, 1.0}}.baseline();
constexpr std::int64_t most_calls = 20'000'000;

Difference against_the_undisturbed(const Sheet& sheet) {
  return largest_difference(sheet, path, 1,
                            [](double xi, double t, Tensor& tau, Tensor& dtau) { jaumann(path, xi, t, tau, dtau); });
}

/// A material that rounds, as one in single precision would: the noise bounds what can be had, and is stated.
void expect_noise_is_stated(double noise) {
  const Sheet sheet(*disturbed_material({{"noise", noise}}), path, {.tolerance = 1e-8, .end = 1});
  const Difference d = against_the_undisturbed(sheet);
  EXPECT_LT(sheet.material_calls(), most_calls) << noise;
  EXPECT_LT(d.tau, std::max(1e-8, 1e4 * noise)) << noise;
  EXPECT_LT(d.tau, 10 * sheet.error_tau()) << noise;
}

TEST(Disturbed, NoiseOfIncrementsIsStatedAndDoesNotStopASheet) { expect_noise_is_stated(1e-11); }
TEST(LongDisturbed, LittleNoiseOfIncrementsIsStatedToo) { expect_noise_is_stated(1e-13); }
TEST(LongDisturbed, MuchNoiseOfIncrementsIsStatedToo) { expect_noise_is_stated(1e-9); }

/// A curve through the rounding of single precision: more nodes would only follow it more closely.
TEST(Disturbed, ACurveOfAMaterialInSinglePrecisionKeepsTheBestOfItsErrors) {
  static const assay_material table = [] {
    assay_material t = *assay_builtin_neo_hookean(ASSAY_ABI_MAJOR, 0);
    t.update = [](void* self, const assay_step* step, std::size_t n, const double* state0, double* state1,
                  double* cauchy, std::int32_t* status, double* dt_factor, char* message) {
      assay_builtin_neo_hookean(ASSAY_ABI_MAJOR, 0)
          ->update(self, step, n, state0, state1, cauchy, status, dt_factor, message);
      for (std::size_t i = 0; i < 9 * n; ++i) cauchy[i] = static_cast<float>(cauchy[i]);
    };
    return t;
  }();
  const Sheet sheet(Material(&table, {{"E", 1e3}, {"nu", 0.3}}), path, {.tolerance = 1e-9, .end = 1});
  ASSERT_TRUE(sheet.is_curve());
  EXPECT_GT(sheet.error_tau(), 1e-9);
  EXPECT_LT(sheet.error_tau(), 1e-5);
  EXPECT_LT(sheet.error_dtau(), 1e-2);
}

TEST(Disturbed, AMaterialThatIsNoFunctionOfItsArgumentsIsRefused) {
  try {
    const Sheet sheet(*disturbed_material({{"restless", 1e-3}}), path, {.tolerance = 1e-8, .end = 1});
    ADD_FAILURE();
  } catch (const MaterialFailure& failure) {
    EXPECT_EQ(std::string(failure.what()).find("its increments do not converge"), 0u) << failure.what();
  }
}

TEST(Disturbed, AFlickeringRegimeIsNotFollowed) {
  const auto material = disturbed_material({{"flickers", 1}});
  const Course course(*material, path, 1, Form::increments);
  History history(course, 1.3, {.tolerance = 1e-10, .watch = true});
  history.advance(1);
  EXPECT_TRUE(history.flickers());
  const Sheet sheet(*material, path, {.tolerance = 1e-8, .end = 1});
  EXPECT_FALSE(sheet.has_kinks());
  EXPECT_LT(sheet.error_tau(), 1e-8);
  EXPECT_LT(against_the_undisturbed(sheet).tau, 1e-8);
  // the same material with a regime that stays is followed
  const auto steady = disturbed_material({});
  const Course calm(*steady, path, 1, Form::increments);
  History other(calm, 1.3, {.tolerance = 1e-10, .watch = true});
  other.advance(1);
  EXPECT_FALSE(other.flickers());
}

}  // namespace
}  // namespace assay::test_sheet_disturbed
