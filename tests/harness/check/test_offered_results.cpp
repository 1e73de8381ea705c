// SPDX-License-Identifier: BSD-3-Clause
// Functions of extensions that leave results unwritten, refuse them, or give what means nothing.
#include <gtest/gtest.h>

#include "harness/check/battery.hpp"
#include "tests/harness/check/model_table.hpp"

namespace assay::check::test_offered_results {
namespace {

using check_tests::PointStep;

enum Deed : int { none, skips, refuses, negative };
enum Function : int { energy, wave_speed };

/// Saint Venant-Kirchhoff's law without a lateral part: P = mu F (C - I).
struct Law {
  static constexpr std::size_t state_size = 0;
  static constexpr double mu = 400;
  int function, deed;

  explicit Law(const double* p) : function(static_cast<int>(p[0])), deed(static_cast<int>(p[1])) {}
  bool rest(const Tensor&, double*) const { return true; }
  void misbehave(std::size_t, double*, double*) const {}
  bool does(int what, int which) const { return deed == what && function == which; }

  static Tensor piola(const Tensor& F) { return mu * F * (F.transpose() * F - Tensor::Identity()); }
  static Tensor cauchy(const Tensor& F) { return piola(F) * F.transpose() / F.determinant(); }
  std::optional<Tensor> take(const PointStep& step, const double*, double*) const {
    if (!(step.F1.determinant() > 0)) return std::nullopt;
    return cauchy(step.F1);
  }
};

/// Leaves the last point out where that is the deed.
template <class Each>
std::int32_t for_points(const void* self, int which, std::size_t n, const Each& each) {
  const Law& law = *static_cast<const Law*>(self);
  if (law.does(refuses, which)) return ASSAY_FAILED;
  for (std::size_t p = 0; p + (law.does(skips, which) ? 1 : 0) < n; ++p) each(law, p);
  return ASSAY_GOOD;
}

std::int32_t energies(void* self, std::size_t n, const double* F, const double*, double* W) {
  return for_points(self, energy, n, [&](const Law&, std::size_t p) {
    const Tensor f = check_tests::read(F, n, p);
    W[p] = 0.25 * Law::mu * (f.transpose() * f - Tensor::Identity()).squaredNorm();
  });
}

std::int32_t speeds(void* self, double density, std::size_t n, const double* F, const double*, const double*,
                    double* speed) {
  return for_points(self, wave_speed, n, [&](const Law& law, std::size_t p) {
    const double bound = std::sqrt(6 * Law::mu / density) * std::pow(check_tests::read(F, n, p).norm(), 2);
    speed[p] = law.does(negative, wave_speed) ? -1 : bound;
  });
}

const void* extension(const char* id) {
  static const assay_energy energy_table{sizeof(assay_energy), energies};
  static const assay_wave_speed speed_table{sizeof(assay_wave_speed), speeds};
  const std::string asked = id;
  if (asked == ASSAY_EXTENSION_ENERGY) return &energy_table;
  return asked == ASSAY_EXTENSION_WAVE_SPEED ? &speed_table : nullptr;
}

Report judged(int function, int deed) {
  static const assay_parameter parameters[] = {{"function", "1", 0, 0, 1, ""}, {"deed", "1", 0, 0, 3, ""}};
  static const assay_material table = [] {
    assay_material t = check_tests::table_of<Law>("offered_for_tests", 0, parameters, {});
    t.extension = extension;
    return t;
  }();
  const std::map<std::string, double> chosen{{"function", function}, {"deed", deed}};
  return run_battery(Material(&table, chosen), {.effort = {.quick = true}});
}

TEST(OfferedResults, AreRightByThemselves) {
  const Report report = judged(energy, none);
  EXPECT_TRUE(report.passes()) << report.diagnosis.front().sentence;
}

TEST(OfferedResults, ThatAreLeftUnwrittenAreNamed) {
  for (const auto& [function, name] : {std::pair(energy, "energy"), {wave_speed, "wave_speed"}}) {
    const Report report = judged(function, skips);
    ASSERT_FALSE(report.diagnosis.empty()) << name;
    EXPECT_EQ(report.diagnosis.front().cause, causes::overrun);
    EXPECT_EQ(report.diagnosis.front().sentence, std::string(name) + " leaves results of points unwritten");
  }
}

TEST(OfferedResults, AnEnergyThatIsRefusedIsNotWrong) {
  const Report report = judged(energy, refuses);
  EXPECT_TRUE(report.passes()) << report.diagnosis.front().sentence;
  for (const TestResult& test : report.tests) {
    const bool is_told = test.sentence.find("refuses to give its energy") != std::string::npos;
    EXPECT_EQ(is_told, test.id == "energy") << test.sentence;
  }
}

TEST(OfferedResults, AWaveSpeedThatIsNoneIsToldSo) {
  for (const int deed : {refuses, negative}) {
    const Report report = judged(wave_speed, deed);
    ASSERT_FALSE(report.diagnosis.empty()) << deed;
    EXPECT_EQ(report.diagnosis.front().cause, causes::wave_speed);
    EXPECT_NE(report.diagnosis.front().sentence.find("gives no wave speed"), std::string::npos);
  }
}

}  // namespace
}  // namespace assay::check::test_offered_results
