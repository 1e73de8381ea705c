// SPDX-License-Identifier: BSD-3-Clause
// The vortex of every model under refinement: the scenes of configs/models at h = .1, .05, .025 [m].
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/drivers/quiet_run.hpp"
#include "tests/drivers/scratch_folder.hpp"

namespace assay::drivers::test_model_orders {
namespace {

using Errors = std::array<double, 3>;

Errors errors_of(const std::string& material, const std::vector<std::string>& more = {}) {
  Errors found{};
  const char* spacings[] = {"0.1", "0.05", "0.025"};
  for (std::size_t k = 0; k < 3; ++k) {
    std::vector<std::string> sets{std::string("grid.spacing=") + spacings[k]};
    sets.insert(sets.end(), more.begin(), more.end());
    const auto result = result_of_run("models/vortex_" + material, sets);
    EXPECT_EQ(result["outcome"], "completed") << material;
    found[k] = result["error"]["l2_max"].get<double>();
  }
  return found;
}

/// Over both halvings of h.
double order_of(const Errors& e) { return 0.5 * std::log2(e[0] / e[2]); }

class LongSmoothModels : public testing::TestWithParam<const char*> {};

// The fluid needs shorter steps: its scene has courant 0.025, and so has neo-Hookean beside it.
TEST(LongModelOrders, TheFluidConvergesAtTheOrderOfNeoHookean) {
  const double expected = order_of(errors_of("neo_hookean", {"method.courant=0.025"}));
  EXPECT_GT(expected, 1.8);
  EXPECT_NEAR(order_of(errors_of("compressible_fluid")), expected, 0.3);
}

TEST_P(LongSmoothModels, ConvergeAtTheOrderOfNeoHookean) {
  static const double expected = order_of(errors_of("neo_hookean"));
  EXPECT_GT(expected, 1.8);
  EXPECT_NEAR(order_of(errors_of(GetParam())), expected, 0.3);
}

INSTANTIATE_TEST_SUITE_P(Scenes, LongSmoothModels,
                         testing::Values("saint_venant_kirchhoff", "mooney_rivlin", "orthotropic_cylindrical",
                                         "hypoelastic_jaumann", "hypoelastic_green_naghdi", "hypoelastic_logarithmic",
                                         "zener", "norton"));

class LongModelsWithKinks : public testing::TestWithParam<const char*> {};

TEST_P(LongModelsWithKinks, ConvergeMonotonically) {
  const Errors e = errors_of(GetParam());
  EXPECT_GT(e[0] / e[1], 2);
  EXPECT_GT(e[1] / e[2], 2);
}

INSTANTIATE_TEST_SUITE_P(Scenes, LongModelsWithKinks,
                         testing::Values("j2_jaumann", "j2_multiplicative", "perzyna", "drucker_prager", "damage"));

// Negative control: a fluid five times as stiff in volume loses its order to the grid.
TEST(LongModelOrders, AStiffFluidFallsShortOfSecondOrder) {
  EXPECT_LT(order_of(errors_of("compressible_fluid", {"material.parameters.bulk_modulus=1e4", "method.courant=0.1"})),
            1.6);
}

// Negative control: at courant 0.4 the material's steps, not the grid, make the error of a model that flows.
TEST(LongModelOrders, FlowAtLongStepsFallsShortOfSecondOrder) {
  EXPECT_LT(order_of(errors_of("norton", {"method.courant=0.4"})), order_of(errors_of("neo_hookean")) - 0.3);
}

}  // namespace
}  // namespace assay::drivers::test_model_orders
