// SPDX-License-Identifier: BSD-3-Clause
// Elasticity with a potential passes however sharply its stiffness changes; what has none is named, or remarked.
#include <gtest/gtest.h>

#include "harness/check/battery.hpp"
#include "tests/harness/check/model_table.hpp"

namespace assay::check::test_potential {
namespace {

using check_tests::PointStep;

/// Kirchhoff stress of W(ln V) = shear |dev e|^2 + bulk tr(e)^2 / 2, with another bulk modulus in compression; or, of a
/// sand, mu 30 x^p (1 + 4 |dev e|^2) with x = max(0, -tr e), to which a little of the first is added.
struct Law {
  static constexpr std::size_t state_size = 0;
  double shear, tension, compression, power;
  bool has_potential;

  explicit Law(const double* p)
      : shear(p[0]), tension(p[1]), compression(p[2]), power(p[3]), has_potential(p[4] != 0) {}
  bool rest(const Tensor&, double*) const { return true; }
  void misbehave(std::size_t, double*, double*) const {}

  std::optional<Tensor> take(const PointStep& step, const double*, double*) const {
    const double J = step.F1.determinant();
    if (!(J > 0)) return std::nullopt;
    const Tensor e = 0.5 * check_tests::logarithm(Tensor(step.F1 * step.F1.transpose())), I = Tensor::Identity();
    const Tensor deviator = check_tests::deviator(e);
    const double volume = std::log(J), x = std::max(0.0, -volume);
    const double bulk = volume < 0 ? compression : tension;
    const double by_volume = has_potential ? 1 : 1 + 0.05 * volume / 0.1;  // a shear modulus that goes with the volume
    Tensor tau = bulk * volume * I + 2 * shear * by_volume * deviator;
    if (power > 0) {
      const double scale = 30 * shear * std::pow(x, power);
      tau += -30 * shear * power * std::pow(x, power - 1) * (1 + 4 * deviator.squaredNorm()) * I + 8 * scale * deviator;
    }
    return tau / J;
  }
};

struct Kind {
  const char* name;
  std::map<std::string, double> parameters;
};

void PrintTo(const Kind& kind, std::ostream* to) { *to << kind.name; }

TestResult dissipation_of(const Report& report) {
  return *std::find_if(report.tests.begin(), report.tests.end(), [](const auto& t) { return t.id == "dissipation"; });
}

Report judged(const Kind& kind, bool quick) {
  static const assay_parameter parameters[] = {{"shear", "Pa", 400, 0, 1e12, ""},
                                               {"tension", "Pa", 800, 0, 1e12, ""},
                                               {"compression", "Pa", 800, 0, 1e12, ""},
                                               {"power", "1", 0, 0, 10, ""},
                                               {"potential", "1", 1, 0, 1, ""}};
  static const assay_material table =
      check_tests::table_of<Law>("potential_for_tests", ASSAY_NON_SMOOTH, parameters, {});
  return run_battery(Material(&table, kind.parameters), {.effort = {.quick = quick}});
}

class WithPotential : public testing::TestWithParam<Kind> {};

TEST_P(WithPotential, Passes) {
  for (const bool quick : {true, false}) {
    const Report report = judged(GetParam(), quick);
    const TestResult test = dissipation_of(report);
    EXPECT_EQ(test.verdict, Verdict::pass) << test.sentence;
    EXPECT_EQ(test.sentence.find("no potential"), std::string::npos) << test.sentence;
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, WithPotential,
                         testing::Values(Kind{"smooth", {}}, Kind{"ten_times_in_compression", {{"compression", 8e3}}},
                                         Kind{"a_hundred_times_in_compression", {{"compression", 8e4}}},
                                         Kind{"stiffer_in_tension", {{"tension", 2.4e4}}},
                                         Kind{"sand_of_power_2", {{"power", 2}}},
                                         Kind{"sand_of_power_4", {{"power", 4}}}),
                         [](const auto& instance) { return std::string(instance.param.name); });

/// However short the steps, the work stays.
TEST(WithoutPotential, IsStillNamed) {
  for (const double compression : {800.0, 8e3}) {
    for (const bool quick : {true, false}) {
      const TestResult test = dissipation_of(judged({"", {{"potential", 0}, {"compression", compression}}}, quick));
      EXPECT_EQ(test.verdict, Verdict::fail) << compression << ": " << test.sentence;
      EXPECT_EQ(test.cause, causes::dissipation);
    }
  }
}

}  // namespace
}  // namespace assay::check::test_potential
